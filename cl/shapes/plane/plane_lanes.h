// SPDX-License-Identifier: MIT
// Ray against LANES planes, anchored form t = n.(P - o) / (n.d): the difference is taken first, so an offset scene
// loses nothing that its input did not lose. Weak (sound in the robust tier): grazing rays far from the anchor.
// Parallel rays, those in the plane included, miss: n.d = 0 gives an infinite or NaN t.

enum { PACKET_BODY_plane_w = PACKET_BODY_PLANE };
#define plane_SURFACES plane_surfaces_w

/// prim: its reals, LANES apart.
FN Ball plane_ball_w(GLOBAL const real* prim) { return ball_of_all(vec3(prim[0], prim[LANES], prim[2 * LANES])); }

#if TIER_ROBUST
#include "shapes/plane/plane_robust_lanes.h"
#elif TIER_COMPENSATED
#include "shapes/plane/plane_compensated_lanes.h"
#elif TIER_FAST
#include "shapes/plane/plane_fast_lanes.h"
#else
FN void plane_block_w(const Ray* ray, GLOBAL const real* block, GLOBAL const int* ids, int slot, Nearest* best) {
  realw gx = load_w(block) - splat_w(ray->o.x);
  realw gy = load_w(block + LANES) - splat_w(ray->o.y);
  realw gz = load_w(block + 2 * LANES) - splat_w(ray->o.z);
  realw nx = load_w(block + 3 * LANES), ny = load_w(block + 4 * LANES), nz = load_w(block + 5 * LANES);
  realw numerator = fma_w(nz, gz, fma_w(ny, gy, nx * gx));
  realw denominator = fma_w(nz, splat_w(ray->d.z), fma_w(ny, splat_w(ray->d.y), nx * splat_w(ray->d.x)));
  realw t = numerator / denominator;
  take_nearest_w(in_range_w(t, ray, best), t, ids, ray->departed, SHAPE_plane, slot, best);
}
#endif
