// SPDX-License-Identifier: MIT
#include "device/primitive_bounds.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <map>

namespace strahl {
namespace {

/// Not above x, not below x.
template <typename Real>
Real rounded_down(double x) {
  const auto nearest = static_cast<Real>(x);
  return static_cast<double>(nearest) > x ? std::nextafter(nearest, -std::numeric_limits<Real>::infinity()) : nearest;
}
template <typename Real>
Real rounded_up(double x) {
  return -rounded_down<Real>(-x);
}

template <typename Real>
Bounds<Real> around_corners(const Real* corners, int count) {
  Bounds<Real> box;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    box[2 * axis] = box[2 * axis + 1] = corners[axis];
    for (int i = 1; i < count; ++i) {
      const Real x = corners[static_cast<std::size_t>(3 * i) + axis];
      box[2 * axis] = std::min(box[2 * axis], x);
      box[2 * axis + 1] = std::max(box[2 * axis + 1], x);
    }
  }
  return box;
}

/// x - by ... x + by; in double once more outwards, which covers the roundings of the difference and of `by`.
template <typename Real>
void widen(Bounds<Real>& box, std::size_t axis, double lo, double hi, double by) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  box[2 * axis] = rounded_down<Real>(std::nextafter(lo - by, -infinite));
  box[2 * axis + 1] = rounded_up<Real>(std::nextafter(hi + by, infinite));
}

template <typename Real>
Bounds<Real> bounds_sphere(const Real* p) {
  Bounds<Real> box;
  for (std::size_t axis = 0; axis < 3; ++axis) widen(box, axis, double(p[axis]), double(p[axis]), double(p[3]));
  return box;
}

template <typename Real>
Bounds<Real> bounds_box(const Real* p) {
  return {p[0], p[1], p[2], p[3], p[4], p[5]};
}

template <typename Real>
Bounds<Real> bounds_triangle(const Real* p) {
  return around_corners(p, 3);
}

template <typename Real>
Bounds<Real> bounds_parallelogram(const Real* p) {
  return around_corners(p, 4);
}

/// How far a circle reaches along an axis: r sqrt(1 - n_i^2 / n.n), from the other two components, and a little more
/// than double rounds.
double reach_of_circle(double radius, double n_i, double n_j, double n_k) {
  const double across = std::hypot(n_j, n_k), all = std::hypot(n_i, across);
  return all > 0 ? radius * (across / all) * (1 + 0x1p-48) : radius;
}

template <typename Real>
Bounds<Real> bounds_disk(const Real* p) {
  Bounds<Real> box;
  const double radius = std::sqrt(double(p[6]));
  for (std::size_t i = 0; i < 3; ++i) {
    const double c = double(p[i]);
    widen(box, i, c, c,
          reach_of_circle(radius, double(p[3 + i]), double(p[3 + (i + 1) % 3]), double(p[3 + (i + 2) % 3])));
  }
  return box;
}

/// The axis is a unit vector rounded to Real: the ends lie off by that, and so does the wall.
template <typename Real>
Bounds<Real> bounds_cylinder(const Real* p) {
  Bounds<Real> box;
  const double length = double(p[6]), radius = double(p[7]);
  const double off = 4 * double(std::numeric_limits<Real>::epsilon()) * (length + radius);
  for (std::size_t i = 0; i < 3; ++i) {
    const double a = double(p[i]), b = a + double(p[3 + i]) * length;
    const double reach =
        reach_of_circle(radius, double(p[3 + i]), double(p[3 + (i + 1) % 3]), double(p[3 + (i + 2) % 3]));
    widen(box, i, std::min(a, b), std::max(a, b), reach + off);
  }
  return box;
}

template <typename Real>
constexpr BoundsFunction<Real> bounds_plane = nullptr;

}  // namespace

template <typename Real>
Bounds<Real> rounded_outwards(const Vec3& lo, const Vec3& hi) {
  return {rounded_down<Real>(lo.x), rounded_up<Real>(hi.x),   rounded_down<Real>(lo.y),
          rounded_up<Real>(hi.y),   rounded_down<Real>(lo.z), rounded_up<Real>(hi.z)};
}

template Bounds<float> rounded_outwards(const Vec3&, const Vec3&);
template Bounds<double> rounded_outwards(const Vec3&, const Vec3&);

template <typename Real>
BoundsFunction<Real> bounds_function(const std::string& kind) {
  static const std::map<std::string, BoundsFunction<Real>> functions = {
#define SHAPE(name, planes) {#name, bounds_##name<Real>},
#include "../../cl/shapes/shapes.def"
#undef SHAPE
  };
  return functions.at(kind);
}

template BoundsFunction<float> bounds_function(const std::string&);
template BoundsFunction<double> bounds_function(const std::string&);

}  // namespace strahl
