// SPDX-License-Identifier: MIT
// Spheres, boxes and planes as Embree's user geometry: the forms of textbooks, one ray at a time.
#pragma once

#include <cmath>
#include <limits>

#include "bench/peers/embree_scene.h"

namespace strahl::bench {

/// Where the ray meets the shape within its range; false: nowhere. Writes the normal's direction.
inline bool meet(const EmbreeSphere& s, const RTCRay& ray, float& t, float normal[3]) {
  const float ox = ray.org_x - s.x, oy = ray.org_y - s.y, oz = ray.org_z - s.z;
  const float a = ray.dir_x * ray.dir_x + ray.dir_y * ray.dir_y + ray.dir_z * ray.dir_z;
  const float b = ox * ray.dir_x + oy * ray.dir_y + oz * ray.dir_z;
  const float c = ox * ox + oy * oy + oz * oz - s.radius * s.radius;
  const float discriminant = b * b - a * c;
  if (discriminant < 0) return false;
  const float root = std::sqrt(discriminant), per_a = 1 / a;
  t = (-b - root) * per_a;
  if (!(t >= ray.tnear)) t = (-b + root) * per_a;
  if (!(t >= ray.tnear && t <= ray.tfar)) return false;
  normal[0] = ox + t * ray.dir_x;
  normal[1] = oy + t * ray.dir_y;
  normal[2] = oz + t * ray.dir_z;
  return true;
}

inline bool meet(const EmbreeBox& box, const RTCRay& ray, float& t, float normal[3]) {
  const float o[3] = {ray.org_x, ray.org_y, ray.org_z}, d[3] = {ray.dir_x, ray.dir_y, ray.dir_z};
  float near = -std::numeric_limits<float>::infinity(), far = std::numeric_limits<float>::infinity();
  int near_axis = 0, far_axis = 0;
  for (int k = 0; k < 3; ++k) {
    const float inverse = 1 / d[k];
    const float t0 = ((inverse < 0 ? box.hi[k] : box.lo[k]) - o[k]) * inverse;
    const float t1 = ((inverse < 0 ? box.lo[k] : box.hi[k]) - o[k]) * inverse;
    if (t0 > near) {
      near = t0;
      near_axis = k;
    }
    if (t1 < far) {
      far = t1;
      far_axis = k;
    }
  }
  if (near > far) return false;
  const bool enters = near >= ray.tnear;
  t = enters ? near : far;
  if (!(t >= ray.tnear && t <= ray.tfar)) return false;
  const int axis = enters ? near_axis : far_axis;
  normal[0] = normal[1] = normal[2] = 0;
  normal[axis] = (d[axis] < 0) == enters ? 1.0F : -1.0F;
  return true;
}

inline bool meet(const EmbreePlane& plane, const RTCRay& ray, float& t, float normal[3]) {
  const float along = plane.normal[0] * ray.dir_x + plane.normal[1] * ray.dir_y + plane.normal[2] * ray.dir_z;
  t = (plane.normal[0] * (plane.point[0] - ray.org_x) + plane.normal[1] * (plane.point[1] - ray.org_y) +
       plane.normal[2] * (plane.point[2] - ray.org_z)) /
      along;
  if (!(t >= ray.tnear && t <= ray.tfar)) return false;
  for (int k = 0; k < 3; ++k) normal[k] = plane.normal[k];
  return true;
}

inline RTCBounds bounds_of(const EmbreeSphere& s) {
  return {s.x - s.radius, s.y - s.radius, s.z - s.radius, 0, s.x + s.radius, s.y + s.radius, s.z + s.radius, 0};
}

inline RTCBounds bounds_of(const EmbreeBox& box) {
  return {box.lo[0], box.lo[1], box.lo[2], 0, box.hi[0], box.hi[1], box.hi[2], 0};
}

/// As far as the rays of the benchmark's scenes go; flat where the plane is level.
inline RTCBounds bounds_of(const EmbreePlane& plane) {
  constexpr float reach = 1e4F;
  RTCBounds box{-reach, -reach, -reach, 0, reach, reach, reach, 0};
  if (plane.normal[0] == 0 && plane.normal[2] == 0) box.lower_y = box.upper_y = plane.point[1];
  return box;
}

template <typename Shape>
void bounds_callback(const RTCBoundsFunctionArguments* arguments) {
  *arguments->bounds_o = bounds_of(static_cast<const Shape*>(arguments->geometryUserPtr)[arguments->primID]);
}

/// N is 1 or, where a packet asks, its size.
template <typename Shape>
void intersect_callback(const RTCIntersectFunctionNArguments* arguments) {
  const Shape& shape = static_cast<const Shape*>(arguments->geometryUserPtr)[arguments->primID];
  float t = 0, normal[3];
  if (arguments->N == 1) {
    auto* ray_hit = reinterpret_cast<RTCRayHit*>(arguments->rayhit);
    if (!arguments->valid[0] || !meet(shape, ray_hit->ray, t, normal)) return;
    ray_hit->ray.tfar = t;
    ray_hit->hit.Ng_x = normal[0];
    ray_hit->hit.Ng_y = normal[1];
    ray_hit->hit.Ng_z = normal[2];
    ray_hit->hit.primID = arguments->primID;
    ray_hit->hit.geomID = arguments->geomID;
    return;
  }
  RTCRayN* rays = RTCRayHitN_RayN(arguments->rayhit, arguments->N);
  RTCHitN* hits = RTCRayHitN_HitN(arguments->rayhit, arguments->N);
  for (unsigned i = 0; i < arguments->N; ++i) {
    if (!arguments->valid[i] || !meet(shape, rtcGetRayFromRayN(rays, arguments->N, i), t, normal)) continue;
    RTCRayN_tfar(rays, arguments->N, i) = t;
    RTCHitN_Ng_x(hits, arguments->N, i) = normal[0];
    RTCHitN_Ng_y(hits, arguments->N, i) = normal[1];
    RTCHitN_Ng_z(hits, arguments->N, i) = normal[2];
    RTCHitN_primID(hits, arguments->N, i) = arguments->primID;
    RTCHitN_geomID(hits, arguments->N, i) = arguments->geomID;
  }
}

template <typename Shape>
void occluded_callback(const RTCOccludedFunctionNArguments* arguments) {
  const Shape& shape = static_cast<const Shape*>(arguments->geometryUserPtr)[arguments->primID];
  constexpr float occluded = -std::numeric_limits<float>::infinity();
  float t = 0, normal[3];
  if (arguments->N == 1) {
    auto* ray = reinterpret_cast<RTCRay*>(arguments->ray);
    if (arguments->valid[0] && meet(shape, *ray, t, normal)) ray->tfar = occluded;
    return;
  }
  for (unsigned i = 0; i < arguments->N; ++i)
    if (arguments->valid[i] && meet(shape, rtcGetRayFromRayN(arguments->ray, arguments->N, i), t, normal))
      RTCRayN_tfar(arguments->ray, arguments->N, i) = occluded;
}

/// One user geometry of all `shapes`, which must outlive it.
template <typename Shape>
void attach_solids(RTCDevice device, RTCScene scene, std::vector<Shape>& shapes) {
  if (shapes.empty()) return;
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
  rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(shapes.size()));
  rtcSetGeometryUserData(geometry, shapes.data());
  rtcSetGeometryBoundsFunction(geometry, bounds_callback<Shape>, nullptr);
  rtcSetGeometryIntersectFunction(geometry, intersect_callback<Shape>);
  rtcSetGeometryOccludedFunction(geometry, occluded_callback<Shape>);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene, geometry);
  rtcReleaseGeometry(geometry);
}

}  // namespace strahl::bench
