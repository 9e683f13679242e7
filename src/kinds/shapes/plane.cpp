// SPDX-License-Identifier: MIT
// Infinite plane.
#include <algorithm>
#include <cmath>
#include <limits>

#include "kinds/rates_of_edges.h"
#include "kinds/shapes.h"

namespace strahl::kinds {

namespace {

constexpr double smallest_normal = std::numeric_limits<double>::min();

double largest(const Vec3& v) { return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)}); }

/// Of vectors that are not zero, whatever their lengths. Readers keep u and v at right angles to the normal up to
/// rounding, which is the larger the nearer u and v are to each other: a cross product of theirs may be the normal.
bool lie_within(const Vec3& a, const Vec3& b, const Vec3& normal) {
  const Vec3 u = normalized(near_unit(a)), v = normalized(near_unit(b)), n = normalized(near_unit(normal));
  const double tolerance = 1e-3 + frame_tolerance / length(cross(u, v));
  return std::fabs(dot(u, n)) <= tolerance && std::fabs(dot(v, n)) <= tolerance;
}

/// In a chosen frame the plane's point nearest the frame's origin: cancellation happens here, in double. In the world's
/// the point as given, which may be exactly representable.
Vec3 anchor(const UploadFrame& frame, const Plane& p) {
  if (!frame.is_chosen) return p.point;
  const Vec3 n = normalized(p.normal);
  return frame.origin + dot(n, p.point - frame.origin) * n;
}

}  // namespace

int primitive_count(const Plane&) { return 1; }

void extend(Extent&, const Plane&) {}

void check(Faults& faults, const Plane& p) {
  faults.require(is_finite(p.point) && is_finite(p.u) && is_finite(p.v), "the plane must be finite");
  faults.require(is_finite(p.normal) && p.normal != Vec3{}, "the normal must be finite and not zero");
  faults.require(!is_finite(p.normal) || p.normal == Vec3{} || largest(p.normal) >= smallest_normal,
                 "the normal's length is {:.3g}; below {:.3g} numbers lose their digits: give it a length near 1",
                 largest(p.normal), smallest_normal);
  faults.require(!is_degenerate(p.u, p.v), "u and v must span the plane");
  if (!is_finite(p.u) || !is_finite(p.v) || !is_finite(p.normal) || p.normal == Vec3{} || is_degenerate(p.u, p.v))
    return;
  faults.require(lie_within(p.u, p.v, p.normal),
                 "u and v must lie in the plane, at right angles to its normal; plane_through() chooses such u and v");
}

void pack(const Planes& to, const Plane& p) {
  to.put(to.primitive().point(anchor(to.frame, p)).vector(near_unit(p.normal)));
}

bool faces_inward(const Plane&) { return false; }

/// Duals of u and v within the plane: dot with them gives the coordinates.
std::optional<std::array<double, 9>> surface_frame(const Plane& p, const UploadFrame& frame) {
  const Vec3 u = frame.vector(p.u), v = frame.vector(p.v);
  const double uu = dot(u, u), uv = dot(u, v), vv = dot(v, v);
  const double inverse = 1 / (uu * vv - uv * uv);
  return nine(inverse * (vv * u - uv * v), inverse * (uu * v - uv * u), frame.point(p.point));
}

void emit(AreaItems&, const Plane&, Primitives) {}

int first_of_area(const Plane&, int, bool) { return -1; }

Vec2 uv_rates(const Plane& p) { return rates_of_edges(p.u, p.v); }

void move(Plane& p, const MapVec3& point, const MapVec3& vector) {
  p.point = point(p.point);
  p.u = vector(p.u);
  p.v = vector(p.v);
}

void scale(Plane&, double) {}

Mirrored mirror(Plane& p, const MapVec3& flip_x) {
  p.normal = flip_x(p.normal);
  return Mirrored::alike;
}

std::optional<Bounds<double>> bounds_plane(const double*, double) { return std::nullopt; }

}  // namespace strahl::kinds
