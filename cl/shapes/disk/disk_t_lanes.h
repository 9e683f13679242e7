// SPDX-License-Identifier: MIT
// Rays against disks, one of each a lane: the plane (plane_lanes.h), then |p - c|^2 <= r^2. One width; no guard.

/// A disk a lane.
typedef struct {
  real3w center, normal;  ///< The normal of any length.
  realw r2;               ///< Radius squared.
} Disks_w;

#if TIER_COMPENSATED
#include "shapes/disk/disk_robust_lanes.h"
#elif TIER_FAST
#include "shapes/disk/disk_fast_lanes.h"
#else
/// t of the lanes of `which` whose line meets the disk, which are left in it. A ray and a disk a lane.
FN realw disk_t_w(real3w o, real3w d, const Disks_w* disk, realw t_min, realw t_max, PRIVATE maskw* which) {
  real3w g = sub3_w(disk->center, o), n = disk->normal;
  realw t = fma_w(n.z, g.z, fma_w(n.y, g.y, n.x * g.x)) / fma_w(n.z, d.z, fma_w(n.y, d.y, n.x * d.x));
  realw px = fma_w(t, d.x, -g.x), py = fma_w(t, d.y, -g.y), pz = fma_w(t, d.z, -g.z);
  *which = *which & le_w(fma_w(pz, pz, fma_w(py, py, px * px)), disk->r2);
  (void)t_min;
  (void)t_max;
  return t;
}
#endif
