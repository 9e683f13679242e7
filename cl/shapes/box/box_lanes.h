// SPDX-License-Identifier: MIT
// Ray against LANES axis-aligned boxes: slabs, comparing t values only (the hit point is never tested).
// After A. Williams et al., "An Efficient and Robust Ray-Box Intersection Algorithm", JGT 10(1), 2005, with compares
// that drop NaN (a ray in a face plane: 0/0) and a correctly rounded divide, so equal faces give equal t.
// The robust tier decides close calls exactly (box_robust_lanes.h).
// From inside, and where the entry lies before t_min, the exit counts. A box is convex: the box just left is met again
// only at its far side, and not at all where the ray leaves through the face that the origin lies on.

enum { PACKET_BODY_box_w = PACKET_BODY_NONE };
#define box_SURFACES box_surfaces_w

/// prim: its reals, LANES apart.
FN Ball box_ball_w(GLOBAL const real* prim) {
  return ball_around_box(vec3(prim[0], prim[2 * LANES], prim[4 * LANES]),
                         vec3(prim[LANES], prim[3 * LANES], prim[5 * LANES]));
}

#if TIER_FAST
#include "shapes/box/box_fast_lanes.h"
#else
FN maskw box_left_outward_w(const Ray* ray, GLOBAL const real* block) {
  // The face nearest to the origin is the one that was left.
  realw nearest = splat_w(REAL_MAX), inward = splat_w(R(0.0));
  for (int axis = 0; axis < 3; ++axis) {
    realw o = splat_w(component(ray->o, axis)), d = splat_w(component(ray->d, axis));
    realw lo = abs_w(load_w(block + 2 * axis * LANES) - o), hi = abs_w(load_w(block + (2 * axis + 1) * LANES) - o);
    inward = sel_w(lt_w(lo, nearest), d, inward);
    nearest = min_w(lo, nearest);
    inward = sel_w(lt_w(hi, nearest), -d, inward);
    nearest = min_w(hi, nearest);
  }
  return ~lt_w(splat_w(R(0.0)), inward);
}

FN void box_block_w(const Ray* ray, GLOBAL const real* block, GLOBAL const int* ids, int slot, Nearest* best) {
  realw ox = splat_w(ray->o.x), oy = splat_w(ray->o.y), oz = splat_w(ray->o.z);
  realw dx = splat_w(ray->d.x), dy = splat_w(ray->d.y), dz = splat_w(ray->d.z);
  int x = ray->near_x, y = ray->near_y, z = ray->near_z;
  realw in_x = (load_w(block + x * LANES) - ox) / dx, out_x = (load_w(block + (x ^ 1) * LANES) - ox) / dx;
  realw in_y = (load_w(block + y * LANES) - oy) / dy, out_y = (load_w(block + (y ^ 1) * LANES) - oy) / dy;
  realw in_z = (load_w(block + z * LANES) - oz) / dz, out_z = (load_w(block + (z ^ 1) * LANES) - oz) / dz;
  realw enter = max_w(in_z, max_w(in_y, max_w(in_x, splat_w(-REAL_MAX))));
  realw leave = min_w(out_z, min_w(out_y, min_w(out_x, splat_w(REAL_MAX))));
  maskw hit = le_w(enter, leave);
#if TIER_ROBUST
  hit = box_exact_w(ray, block, ids, enter, leave, hit);
#endif
  realw t = sel_w(le_w(splat_w(ray->t_min), enter), enter, leave);
  maskw departed = none_w();
  if (ray->departed >= 0) {
    departed = is_departed_w(ids, ray);
    if (any_w(departed)) {
      t = sel_w(departed, leave, t);
      // enter <= leave is not required: for a grazing ray whose origin was rounded out of the box, enter is larger than
      // leave.
      hit = (hit & ~departed) | (departed & lt_w(splat_w(R(0.0)), leave) & ~box_left_outward_w(ray, block));
    }
  }
#if TIER_ROBUST
  if (!any_w(hit)) return;
  t = box_t_w(ray, block, hit & is_there_w(ids), departed, t, vec3_w(in_x, in_y, in_z), vec3_w(out_x, out_y, out_z));
#endif
  // REAL_MAX stands for an exit beyond the range of real, which is no hit.
  hit = hit & lt_w(t, splat_w(REAL_MAX));
  take_nearest_w(hit & in_range_w(t, ray, best), t, ids, -1, SHAPE_box, slot, best);
}
#endif
