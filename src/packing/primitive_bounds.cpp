// SPDX-License-Identifier: MIT
#include "packing/primitive_bounds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "kinds/shapes.h"

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
Bounds<Real> outwards(const Bounds<double>& box) {
  return rounded_outwards<Real>({box[0], box[2], box[4]}, {box[1], box[3], box[5]});
}

/// Of a bounded kind. of: its file's (kinds/shapes.h).
template <typename Real, std::size_t planes, std::optional<Bounds<double>> (*of)(const double*, double)>
Bounds<Real> bounds_of(const Real* p) {
  std::array<double, planes> values;
  std::copy_n(p, planes, values.begin());
  return outwards<Real>(*of(values.data(), double(std::numeric_limits<Real>::epsilon())));
}

}  // namespace

template <typename Real>
Bounds<Real> rounded_outwards(const Vec3& lo, const Vec3& hi) {
  return {rounded_down<Real>(lo.x), rounded_up<Real>(hi.x),   rounded_down<Real>(lo.y),
          rounded_up<Real>(hi.y),   rounded_down<Real>(lo.z), rounded_up<Real>(hi.z)};
}

template Bounds<float> rounded_outwards(const Vec3&, const Vec3&);
template Bounds<double> rounded_outwards(const Vec3&, const Vec3&);

namespace {

bool is_bounded(std::optional<Bounds<double>> (*of)(const double*, double)) {
  constexpr std::array<double, 12> planes{};
  return of(planes.data(), 0).has_value();
}

}  // namespace

template <typename Real>
BoundsFunction<Real> bounds_function(const std::string& kind) {
  static const std::map<std::string, BoundsFunction<Real>> functions = {
#define SHAPE(name, planes) \
  {#name, is_bounded(kinds::bounds_##name) ? bounds_of<Real, planes, kinds::bounds_##name> : nullptr},
#include "../../cl/shapes/shapes.def"
#undef SHAPE
  };
  return functions.at(kind);
}

template BoundsFunction<float> bounds_function(const std::string&);
template BoundsFunction<double> bounds_function(const std::string&);

}  // namespace strahl
