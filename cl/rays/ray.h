// SPDX-License-Identifier: MIT
// A ray, with the prepared values that intersection bodies of every width need. Frame: the one the scene was uploaded
// in.
#ifndef STRAHL_RAYS_RAY_H
#define STRAHL_RAYS_RAY_H

#include "math/vec3.h"
#include "portable.h"
#if TIER_FAST
#include "hits/epsilon_fast.h"
#endif

/// The direction is scaled by an exact power of two so that max |d_i| lies in [1, 2): tiny and huge directions then
/// neither underflow nor overflow. t of this ray = t of the given ray times t_scale.
typedef struct {
  real3 o, d;
  real t_min, t_max;   ///< Both inclusive; in units of d.
  real t_from_scaled;  ///< t in units of the direction as given = t * t_from_scaled.
  int departed;        ///< Scene-wide id of the primitive just left, -1: none. It is not hit again where it was left.
  int departed_instance;  ///< That it belongs to; -1: none.
  int aim;         ///< Id of the primitive that the ray ends on, -1: none. Polygons and the textbook's sphere are
                   ///< then not in the way of themselves; of other kinds the exact test may say so, too.
  int is_outward;  ///< 1: that primitive is convex and the ray goes away from it, so it is not hit again at all.

  real3 inv;  ///< 1 / d, infinite where d is 0.
#if TIER_COMPENSATED
  real dd, dd_rest, dd_inverse;  ///< d.d as a double word, and 1 / (d.d).
  real t_per_length;             ///< 1 / |d|, or up to 2^-20 of it more.
#endif
  real3 slack;                     ///< By how much slabs are widened, in t, per axis (widen_rays).
  int near_x, near_y, near_z;      ///< Plane of a box (0 lo_x, 1 hi_x, 2 lo_y, ...) that the ray meets first, per axis.
  int kx, ky, kz;                  ///< Axes of the shear: kz the largest of |d|, the others after it in turn. Not
                                   ///< exchanged where d looks backwards: hits from both sides count, and a mirrored
                                   ///< scene has the same bits.
  real shear_x, shear_y, shear_z;  ///< Woop, Benthin, Wald, "Watertight Ray/Triangle Intersection", JCGT 2(1), 2013.
} Ray;

/// The planes that rays/prepared_lanes.h prepares.
enum {
  RAY_PLANE_O = 0,
  RAY_PLANE_D = 3,
  RAY_PLANE_T_MIN = 6,
  RAY_PLANE_T_MAX = 7,
  RAY_PLANE_T_FROM_SCALED = 8,
  RAY_PLANE_INV = 9,
  RAY_PLANE_SLACK = 12,
  RAY_PLANE_SHEAR = 15,  // kz, shear_x, shear_y, shear_z
  RAY_PLANE_DD = 19,     // dd, dd_rest, dd_inverse, t_per_length
  RAY_PLANES = 23
};

#if LANES == 16
#undef LANES
#define LANES 1
#include "lanes/lane_ops.h"
#include "rays/prepared_lanes.h"
#undef LANES
#define LANES 16
#elif LANES == 8
#undef LANES
#define LANES 1
#include "lanes/lane_ops.h"
#include "rays/prepared_lanes.h"
#undef LANES
#define LANES 8
#elif defined(LANES)
#include "lanes/lane_ops.h"
#include "rays/prepared_lanes.h"
#else
#define LANES 1
#include "lanes/lane_ops.h"
#include "rays/prepared_lanes.h"
#undef LANES
#endif

FN real component(real3 v, int axis) { return real_select(real_select(v.z, v.y, axis == 1), v.x, axis == 0); }

FN GivenRays_w_1 given_ray(real3 o, real3 d, real t_min, real t_max, int departed) {
  GivenRays_w_1 given;
  given.ox = o.x;
  given.oy = o.y;
  given.oz = o.z;
  given.dx = d.x;
  given.dy = d.y;
  given.dz = d.z;
  given.t_min = t_min;
  given.t_max = t_max;
  given.has_departed = nonzero_w_1(departed + 1);
  return given;
}

FN Ray ray_make(real3 o, real3 d, real t_min, real t_max, int departed) {
  real planes[RAY_PLANES];
  GivenRays_w_1 given = given_ray(o, d, t_min, t_max, departed);
  prepare_rays_w_1(&given, planes);
  // No loop: PoCL keeps an array that a loop runs over in memory (docs/decisions/0017-once.md).
  planes[RAY_PLANE_SLACK] = planes[RAY_PLANE_SLACK + 1] = planes[RAY_PLANE_SLACK + 2] = REAL_MAX;
  return prepared_ray_w_1(planes, 0, departed);
}

/// widen_rays of rays/prepared_lanes.h.
FN void ray_widen(Ray* ray, GLOBAL const real* reach) {
  real planes[RAY_PLANES];
  planes[RAY_PLANE_O] = ray->o.x;
  planes[RAY_PLANE_O + 1] = ray->o.y;
  planes[RAY_PLANE_O + 2] = ray->o.z;
  planes[RAY_PLANE_D] = ray->d.x;
  planes[RAY_PLANE_D + 1] = ray->d.y;
  planes[RAY_PLANE_D + 2] = ray->d.z;
  planes[RAY_PLANE_INV] = ray->inv.x;
  planes[RAY_PLANE_INV + 1] = ray->inv.y;
  planes[RAY_PLANE_INV + 2] = ray->inv.z;
  widen_rays_w_1(nonzero_w_1(ray->departed + 1), planes, reach);
  ray->slack = vec3(planes[RAY_PLANE_SLACK], planes[RAY_PLANE_SLACK + 1], planes[RAY_PLANE_SLACK + 2]);
}

/// t of a hit in units of the direction as given, held within the range asked for: scaling may round denormal numbers.
FN real ray_given_t(const Ray* ray, real t, real t_min, real t_max) {
  t *= ray->t_from_scaled;
  if (t < t_min) t = t_min;
  if (t_max < t) t = t_max;
  return t;
}

#endif
