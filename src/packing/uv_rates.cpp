// SPDX-License-Identifier: MIT
#include "packing/uv_rates.h"

#include <algorithm>
#include <limits>

#include "kinds/shapes.h"

namespace strahl {
namespace {

/// Finite also in single precision: a shape thinner than its numbers has no filter worth the name.
double usable(double rate) {
  const double most = std::numeric_limits<float>::max();
  return rate > 0 ? std::min(rate, most) : 0;
}

}  // namespace

Vec2 uv_rates(const Geometry& geometry, const UploadFrame& frame) {
  const Vec2 rates = std::visit([](const auto& shape) { return kinds::uv_rates(shape); }, geometry);
  return {usable(rates.x / frame.scale), usable(rates.y / frame.scale)};
}

}  // namespace strahl
