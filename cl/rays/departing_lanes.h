// SPDX-License-Identifier: MIT
// LANES rays, and the primitives that each of them leaves and ends on. One width; no guard.
#include "rays/ray.h"
#if LANES != 1
#include "rays/prepared_lanes.h"
#endif

typedef struct {
  realw planes[RAY_PLANES];  ///< As rays/prepared_lanes.h has prepared them.
  intw departed, departed_instance, aim, is_outward;
} Rays_w;

/// Rays as in GivenRays_w, prepared and not widened yet.
FN void rays_make_w(real3w o, real3w d, realw t_min, realw t_max, maskw has_departed, Rays_w* rays) {
  GivenRays_w given;
  given.ox = o.x;
  given.oy = o.y;
  given.oz = o.z;
  given.dx = d.x;
  given.dy = d.y;
  given.dz = d.z;
  given.t_min = t_min;
  given.t_max = t_max;
  given.has_departed = has_departed;
  prepare_rays_w(&given, rays->planes);
  // No loop: PoCL keeps an array that a loop runs over in memory (docs/decisions/0017-once.md).
  rays->planes[RAY_PLANE_SLACK] = rays->planes[RAY_PLANE_SLACK + 1] = rays->planes[RAY_PLANE_SLACK + 2] =
      splat_w(REAL_MAX);
}

FN Ray ray_of_w(const Rays_w* rays, int lane) {
  Ray ray = prepared_ray_w(rays->planes, lane, get_int_w(&rays->departed, lane));
  if (HAS_INSTANCES) ray.departed_instance = get_int_w(&rays->departed_instance, lane);
  ray.aim = get_int_w(&rays->aim, lane);
  ray.is_outward = get_int_w(&rays->is_outward, lane);
  return ray;
}
