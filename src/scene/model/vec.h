// SPDX-License-Identifier: MIT
// Vectors, colours and affine transforms of the host: always double, never rounded before packing.
#pragma once

#include <array>

namespace strahl {

struct Vec2 {
  double x = 0, y = 0;
  friend bool operator==(const Vec2&, const Vec2&) = default;
};

struct Vec3 {
  double x = 0, y = 0, z = 0;
  friend bool operator==(const Vec3&, const Vec3&) = default;
};

/// Linear RGB, sRGB primaries; radiometric units where it is a radiance or an intensity.
struct Rgb {
  double r = 0, g = 0, b = 0;
  friend bool operator==(const Rgb&, const Rgb&) = default;
};

/// Three equal numbers.
[[nodiscard]] constexpr Rgb grey(double value) { return {value, value, value}; }

[[nodiscard]] Vec3 operator+(const Vec3& a, const Vec3& b);
[[nodiscard]] Vec3 operator-(const Vec3& a, const Vec3& b);
[[nodiscard]] Vec3 operator-(const Vec3& a);
[[nodiscard]] Vec3 operator*(double s, const Vec3& v);
[[nodiscard]] double dot(const Vec3& a, const Vec3& b);
[[nodiscard]] Vec3 cross(const Vec3& a, const Vec3& b);
[[nodiscard]] double length(const Vec3& v);
/// The largest of |x|, |y| and |z|.
[[nodiscard]] double largest_component(const Vec3& v);
/// v / |v|, safe against overflow and underflow; v must not be zero.
[[nodiscard]] Vec3 normalized(const Vec3& v);
[[nodiscard]] bool is_finite(const Vec3& v);
[[nodiscard]] bool is_finite(const Rgb& c);
/// Two unit vectors that complete the unit vector n to a right-handed frame (s, t, n).
/// Duff et al., "Building an Orthonormal Basis, Revisited", JCGT 6(1), 2017.
[[nodiscard]] std::array<Vec3, 2> orthonormal_basis(const Vec3& n);

/// Affine map p -> M p + t, row-major 3 x 4 (the last row 0 0 0 1 is implied).
struct Transform {
  std::array<std::array<double, 4>, 3> m{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};

  [[nodiscard]] Vec3 point(const Vec3& p) const;
  [[nodiscard]] Vec3 vector(const Vec3& v) const;
  /// The inverse-transpose applied to n (not normalised); the linear part must not be singular.
  [[nodiscard]] Vec3 normal(const Vec3& n) const;
  /// The linear part must not be singular.
  [[nodiscard]] Transform inverse() const;
  /// Column i of the linear part.
  [[nodiscard]] Vec3 column(int i) const;
  [[nodiscard]] Vec3 translation() const { return {m[0][3], m[1][3], m[2][3]}; }
  [[nodiscard]] double determinant() const;
  [[nodiscard]] bool is_finite() const;
};

/// Applies b first, then a.
[[nodiscard]] Transform operator*(const Transform& a, const Transform& b);

}  // namespace strahl
