// SPDX-License-Identifier: MIT
// The planes of primitives, as a shape's file writes them (kinds/shapes.h): points and lengths move into the frame,
// everything else stays.
#pragma once

#include <array>
#include <functional>
#include <span>

#include "kinds/upload_frame.h"

namespace strahl {

/// Receives the planes of one primitive; positions are relative to the frame, still double.
using PrimitiveSink = std::function<void(std::span<const double> planes)>;

namespace kinds {

/// The planes of one primitive.
struct PrimitivePlanes {
  const UploadFrame& frame;
  std::array<double, 12> values{};
  std::size_t size = 0;

  PrimitivePlanes& number(double x) {
    values[size++] = x;
    return *this;
  }
  PrimitivePlanes& vector(const Vec3& v) { return number(v.x).number(v.y).number(v.z); }
  PrimitivePlanes& point(const Vec3& p) { return vector(frame.point(p)); }
  PrimitivePlanes& length(double x) { return number(frame.scale * x); }
};

struct Planes {
  const UploadFrame& frame;
  const PrimitiveSink& sink;

  [[nodiscard]] PrimitivePlanes primitive() const { return PrimitivePlanes{frame}; }
  void put(const PrimitivePlanes& planes) const { sink({planes.values.data(), planes.size}); }
  void parallelogram(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) const {
    put(primitive().point(a).point(b).point(c).point(d));
  }
};

/// Scales a normal by a power of two to a length near 1. The length of a normal has no meaning, and products with it
/// stay in range.
[[nodiscard]] Vec3 near_unit(const Vec3& normal);

/// x y z of each in turn.
[[nodiscard]] inline std::array<double, 9> nine(const Vec3& a, const Vec3& b, const Vec3& c) {
  return {a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z};
}

}  // namespace kinds
}  // namespace strahl
