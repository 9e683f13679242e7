// SPDX-License-Identifier: MIT
// Ray against LANES open cylinders (cylinder_hits_lanes.h).

enum { PACKET_BODY_cylinder_w = PACKET_BODY_CYLINDER };

/// prim: its reals, LANES apart.
FN Ball cylinder_ball_w(GLOBAL const real* prim) {
  // Centred at the foot of the axis; the radius reaches the rim of the other end.
  return ball_of(vec3(prim[0], prim[LANES], prim[2 * LANES]), prim[7 * LANES] + prim[6 * LANES]);
}

#if TIER_COMPENSATED
#include "shapes/cylinder/cylinder_slabs_lanes.h"
#endif

FN void cylinder_block_w(const Ray* ray, GLOBAL const real* block, GLOBAL const int* ids, int slot, Nearest* best) {
  Cylinders_w cylinder;
  cylinder.foot = load_planes3_w(block);
  cylinder.axis = load_planes3_w(block + 3 * LANES);
  cylinder.length = load_w(block + 6 * LANES);
  cylinder.r = load_w(block + 7 * LANES);
  real3w o = splat3_w(ray->o), d = splat3_w(ray->d);
  maskw which = is_there_w(ids), departed = none_w();
#if TIER_ROBUST
  real3w f = sub3_w(o, cylinder.foot);
  which = which & within_reach_w(ray, best, f.x, f.y, f.z, cylinder.r + cylinder.length);
#endif
  if (!TIER_FAST && ray->departed >= 0) departed = is_departed_w(ids, ray);
  if (!any_w(which | departed)) return;
  CylinderHits_w hits = cylinder_hits_w(o, d, &cylinder, splat_w(ray->t_min), which, departed);
#if TIER_COMPENSATED
  if (ray->departed >= 0)
    hits.which = hits.which & (~departed | within_cylinder_slabs_w(ray, block, cylinder_about_w(&hits)));
#endif
  if (ray->is_outward) hits.which = hits.which & ~departed;
  realw t = cylinder_t_w(o, d, &cylinder, &hits, departed);
  take_nearest_w(hits.which & in_range_w(t, ray, best), t, ids, -1, SHAPE_cylinder, slot, best);
}
