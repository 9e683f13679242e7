// SPDX-License-Identifier: MIT
// LANES rays, and what each of them leaves and ends on. One width; no guard.
#include "core/ray.h"
#if LANES != 1
#include "core/ray_lanes.h"
#endif

typedef struct {
  realw planes[RAY_PLANES];  ///< As core/ray_lanes.h has prepared them.
  intw left, left_instance, aim, is_outward;
} LANED(Rays);

FN real3w LANED(real3_at)(PRIVATE const realw* planes) { return vec3_w(planes[0], planes[1], planes[2]); }

/// Rays as in LANED(GivenRays), prepared and not widened yet.
FN void LANED(rays_make)(real3w o, real3w d, realw t_min, realw t_max, maskw has_left, LANED(Rays) * rays) {
  LANED(GivenRays) given;
  given.ox = o.x;
  given.oy = o.y;
  given.oz = o.z;
  given.dx = d.x;
  given.dy = d.y;
  given.dz = d.z;
  given.t_min = t_min;
  given.t_max = t_max;
  given.has_left = has_left;
  LANED(prepare_rays)(&given, rays->planes);
  // One by one: PoCL 3.1 keeps an array that a loop runs over in memory, for good.
  rays->planes[RAY_PLANE_SLACK] = rays->planes[RAY_PLANE_SLACK + 1] = rays->planes[RAY_PLANE_SLACK + 2] =
      splat_w(REAL_MAX);
}

FN Ray LANED(ray_of)(const LANED(Rays) * rays, int lane) {
  Ray ray = LANED(prepared_ray)(rays->planes, lane, get_int_w(&rays->left, lane));
  if (HAS_INSTANCES) ray.left_instance = get_int_w(&rays->left_instance, lane);
  ray.aim = get_int_w(&rays->aim, lane);
  ray.is_outward = get_int_w(&rays->is_outward, lane);
  return ray;
}
