// SPDX-License-Identifier: MIT
// Ray against LANES disks: the anchored plane (plane_lanes.h), then |p - c|^2 <= r^2.

enum { PACKET_BODY_disk_w = PACKET_BODY_DISK };
#define disk_SURFACES disk_surfaces_w

/// prim: its reals, LANES apart.
FN Ball disk_ball_w(GLOBAL const real* prim) {
  return ball_of(vec3(prim[0], prim[LANES], prim[2 * LANES]), real_sqrt(prim[6 * LANES]));
}

#if TIER_COMPENSATED
#include "shapes/disk/disk_hit_lanes.h"
#include "shapes/disk/disk_robust_lanes.h"
#elif TIER_FAST
#include "shapes/disk/disk_fast_lanes.h"
#else
FN void disk_block_w(const Ray* ray, GLOBAL const real* block, GLOBAL const int* ids, int slot, Nearest* best) {
  realw gx = load_w(block) - splat_w(ray->o.x);
  realw gy = load_w(block + LANES) - splat_w(ray->o.y);
  realw gz = load_w(block + 2 * LANES) - splat_w(ray->o.z);
  realw nx = load_w(block + 3 * LANES), ny = load_w(block + 4 * LANES), nz = load_w(block + 5 * LANES);
  realw dx = splat_w(ray->d.x), dy = splat_w(ray->d.y), dz = splat_w(ray->d.z);
  realw t = fma_w(nz, gz, fma_w(ny, gy, nx * gx)) / fma_w(nz, dz, fma_w(ny, dy, nx * dx));
  realw px = fma_w(t, dx, -gx), py = fma_w(t, dy, -gy), pz = fma_w(t, dz, -gz);
  maskw hit = le_w(fma_w(pz, pz, fma_w(py, py, px * px)), load_w(block + 6 * LANES));
  take_nearest_w(hit & in_range_w(t, ray, best), t, ids, ray->departed, SHAPE_disk, slot, best);
}
#endif
