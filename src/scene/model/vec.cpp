// SPDX-License-Identifier: MIT
// Vectors and affine maps in double (vec.h). Lengths and inverse transposes are scaled by powers of two, which is
// exact, so that scenes of any size neither overflow nor underflow.
#include "scene/model/vec.h"

#include <algorithm>
#include <cmath>

namespace strahl {

Vec3 operator+(const Vec3& a, const Vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Vec3 operator-(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Vec3 operator-(const Vec3& a) { return {-a.x, -a.y, -a.z}; }
Vec3 operator*(double s, const Vec3& v) { return {s * v.x, s * v.y, s * v.z}; }
double dot(const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
double length(const Vec3& v) { return std::hypot(v.x, v.y, v.z); }
double largest_component(const Vec3& v) { return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)}); }

Vec3 normalized(const Vec3& v) {
  const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  const int exponent = largest > 0 ? std::ilogb(largest) : 0;  // Of 0 and of no number it is one that has no negative.
  const Vec3 scaled{std::scalbn(v.x, -exponent), std::scalbn(v.y, -exponent), std::scalbn(v.z, -exponent)};
  const double norm = std::sqrt(dot(scaled, scaled));
  return {scaled.x / norm, scaled.y / norm, scaled.z / norm};
}

bool is_finite(const Vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }
bool is_finite(const Rgb& c) { return std::isfinite(c.r) && std::isfinite(c.g) && std::isfinite(c.b); }

std::array<Vec3, 2> orthonormal_basis(const Vec3& n) {
  const double sign = std::copysign(1.0, n.z);
  const double a = -1.0 / (sign + n.z);
  const double b = n.x * n.y * a;
  return {Vec3{1.0 + sign * n.x * n.x * a, sign * b, -sign * n.x}, Vec3{b, sign + n.y * n.y * a, -n.y}};
}

Vec3 Transform::vector(const Vec3& v) const {
  const auto row = [&](const std::array<double, 4>& r) { return r[0] * v.x + r[1] * v.y + r[2] * v.z; };
  return {row(m[0]), row(m[1]), row(m[2])};
}

Vec3 Transform::point(const Vec3& p) const { return vector(p) + translation(); }

Vec3 Transform::column(int i) const {
  const auto c = static_cast<std::size_t>(i);
  return {m[0][c], m[1][c], m[2][c]};
}

double Transform::determinant() const { return dot(column(0), cross(column(1), column(2))); }

namespace {

/// A power of two that brings the largest number of the linear part near 1.
double ordinary_scale(const Transform& transform) {
  double largest = 0;
  for (const auto& row : transform.m)
    for (std::size_t i = 0; i < 3; ++i) largest = std::max(largest, std::abs(row[i]));
  return std::scalbn(1.0, -std::ilogb(largest));
}

}  // namespace

Vec3 Transform::normal(const Vec3& n) const {
  const double scale = ordinary_scale(*this);
  const Vec3 c0 = scale * column(0), c1 = scale * column(1), c2 = scale * column(2);
  const Vec3 cofactors = n.x * cross(c1, c2) + n.y * cross(c2, c0) + n.z * cross(c0, c1);
  return (scale / dot(c0, cross(c1, c2))) * cofactors;
}

Transform Transform::inverse() const {
  const double scale = ordinary_scale(*this);
  const Vec3 c0 = scale * column(0), c1 = scale * column(1), c2 = scale * column(2);
  const double factor = scale / dot(c0, cross(c1, c2));
  const std::array rows{factor * cross(c1, c2), factor * cross(c2, c0), factor * cross(c0, c1)};
  Transform inverted;
  for (std::size_t i = 0; i < 3; ++i) inverted.m[i] = {rows[i].x, rows[i].y, rows[i].z, -dot(rows[i], translation())};
  return inverted;
}

Transform operator*(const Transform& a, const Transform& b) {
  Transform product;
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t col = 0; col < 4; ++col) {
      product.m[row][col] = a.m[row][0] * b.m[0][col] + a.m[row][1] * b.m[1][col] + a.m[row][2] * b.m[2][col];
    }
    product.m[row][3] += a.m[row][3];
  }
  return product;
}

bool Transform::is_finite() const {
  return strahl::is_finite(column(0)) && strahl::is_finite(column(1)) && strahl::is_finite(column(2)) &&
         strahl::is_finite(translation());
}

}  // namespace strahl
