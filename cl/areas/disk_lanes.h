// SPDX-License-Identifier: MIT
// Disk: centre, two perpendicular radii, unit normal on the side that emits.
#include "math/atan2_lanes.h"

FN AreaPoint_w disk_point_w(PRIVATE const realw* item, PRIVATE const realw* area, real3w from, realw u, realw v) {
  Real2_w weights = square_to_disk_w(u, v);
  return flat_point_w(item, area, from, weights.x, weights.y);
}

FN realw disk_reach_w(PRIVATE const realw* item) { return flat_reach_w(item); }

FN realw disk_density_w(PRIVATE const realw* item, PRIVATE const realw* area, real3w from, real3w towards,
                        real3w normal) {
  (void)item;
  (void)from;
  return uniform_density_w(area, towards, normal);
}

/// Distance from the centre in radii, angle in turns.
FN Real2_w disk_uv_w(GLOBAL const real* uvs, intw item, const AreaPoint_w* p, real side) {
  (void)uvs;
  (void)item;
  (void)side;
  Real2_w uv;
  uv.x = min_w(sqrt_w(fma_w(p->u, p->u, p->v * p->v)), splat_w(R(1.0)));
  uv.y = atan2_turns_w(p->v, p->u);
  return uv;
}
