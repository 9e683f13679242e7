// SPDX-License-Identifier: MIT
// Rotations by Rodrigues' formula, exact for multiples of 90 degrees around a coordinate axis.
#include "scene/model/transforms.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace strahl {
namespace {

// A cross product or determinant of unit vectors carries a few roundings of 2^-53 each; 16 of them decide nothing.
constexpr double rounding = 16 * 0x1p-53;

}  // namespace

std::pair<double, double> sin_cos_degrees(double degrees) {
  const double turn = std::remainder(degrees, 360.0);
  const double quarter = std::nearbyint(turn / 90.0);
  const double rest = (turn - 90.0 * quarter) * (std::numbers::pi / 180.0);
  const double s = std::sin(rest), c = std::cos(rest);
  switch ((static_cast<int>(quarter) % 4 + 4) % 4) {
    case 0:
      return {s, c};
    case 1:
      return {c, -s};
    case 2:
      return {-s, -c};
    default:
      return {-c, s};
  }
}

Transform rotation(const Vec3& axis, double degrees) {
  const auto [s, c] = sin_cos_degrees(degrees);
  const Vec3 a = normalized(axis);
  const double k = 1 - c;
  return Transform{{{{c + a.x * a.x * k, a.x * a.y * k - a.z * s, a.x * a.z * k + a.y * s, 0},
                     {a.y * a.x * k + a.z * s, c + a.y * a.y * k, a.y * a.z * k - a.x * s, 0},
                     {a.z * a.x * k - a.y * s, a.z * a.y * k + a.x * s, c + a.z * a.z * k, 0}}}};
}

std::optional<Transform> look_at(const Vec3& origin, const Vec3& target, const Vec3& up) {
  if (origin == target || up == Vec3{} || !is_finite(target - origin)) return std::nullopt;
  const Vec3 forward = normalized(target - origin);
  const Vec3 side = cross(normalized(up), forward);
  if (length(side) <= rounding) return std::nullopt;
  const Vec3 left = normalized(side);
  const Vec3 upward = cross(forward, left);
  return Transform{{{{left.x, upward.x, forward.x, origin.x},
                     {left.y, upward.y, forward.y, origin.y},
                     {left.z, upward.z, forward.z, origin.z}}}};
}

/// The largest eigenvalue of a symmetric matrix by the trigonometric form of its cubic (Smith, "Eigenvalues of a
/// symmetric 3 x 3 matrix", CACM 4(4), 1961).
double largest_stretch(const Transform& transform) {
  const Vec3 x = transform.column(0), y = transform.column(1), z = transform.column(2);
  const double unit = std::max({length(x), length(y), length(z)});
  if (!(unit > 0) || !std::isfinite(unit)) return unit;
  const auto product = [&](const Vec3& a, const Vec3& b) { return dot((1 / unit) * a, (1 / unit) * b); };
  const double mean = (product(x, x) + product(y, y) + product(z, z)) / 3;
  const double xx = product(x, x) - mean, yy = product(y, y) - mean, zz = product(z, z) - mean;
  const double xy = product(x, y), xz = product(x, z), yz = product(y, z);
  const double spread = std::sqrt((xx * xx + yy * yy + zz * zz + 2 * (xy * xy + xz * xz + yz * yz)) / 6);
  if (!(spread > 0)) return unit * std::sqrt(mean);
  const double determinant = xx * (yy * zz - yz * yz) - xy * (xy * zz - yz * xz) + xz * (xy * yz - yy * xz);
  const double cosine = std::clamp(determinant / (2 * spread * spread * spread), -1.0, 1.0);
  return unit * std::sqrt(mean + 2 * spread * std::cos(std::acos(cosine) / 3));
}

std::array<Vec3, 3> unscaled_columns(const Transform& transform) {
  const double factor = 1 / std::cbrt(std::fabs(transform.determinant()));
  return {factor * transform.column(0), factor * transform.column(1), factor * transform.column(2)};
}

std::optional<std::array<Vec3, 3>> nearest_axes(const std::array<Vec3, 3>& axes) {
  constexpr double tolerance = 1e-3;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j <= i; ++j)
      if (!(std::fabs(dot(axes[i], axes[j]) - (i == j ? 1 : 0)) <= tolerance)) return std::nullopt;
  std::array<Vec3, 3> nearest = axes;
  // Newton's iteration, the mean with the inverse transpose (N. Higham, "Computing the Polar Decomposition - with
  // Applications", 1986): 10^-3 is squared in each step, and the third is within rounding.
  for (int step = 0; step < 3; ++step) {
    const auto& [a, b, c] = nearest;
    const double half = 0.5 / dot(a, cross(b, c));
    nearest = {0.5 * a + half * cross(b, c), 0.5 * b + half * cross(c, a), 0.5 * c + half * cross(a, b)};
  }
  return nearest;
}

std::string singular_because(const Transform& transform) {
  const Vec3 x = transform.column(0), y = transform.column(1), z = transform.column(2);
  const double lengths[] = {length(x), length(y), length(z)};
  const double shortest = *std::min_element(lengths, lengths + 3), longest = *std::max_element(lengths, lengths + 3);
  if (shortest == 0) return "a column is zero";
  if (!std::isfinite(longest) || longest < std::numeric_limits<double>::min())
    return "its numbers are too large or too small to be inverted";
  if (shortest <= rounding * longest)
    return fmt::format("the longest of its columns measures {:.3g}, the shortest {:.3g}, which is nothing beside it",
                       longest, shortest);
  const bool is_flat = std::abs(dot(cross(normalized(x), normalized(y)), normalized(z))) <= rounding;
  return is_flat ? "its columns lie in one plane" : "";
}

}  // namespace strahl
