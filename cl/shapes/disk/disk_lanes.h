// SPDX-License-Identifier: MIT
// Ray against LANES disks (disk_t_lanes.h).

enum { PACKET_BODY_disk_w = PACKET_BODY_DISK };

/// prim: its reals, LANES apart.
FN Ball disk_ball_w(GLOBAL const real* prim) {
  return ball_of(vec3(prim[0], prim[LANES], prim[2 * LANES]), real_sqrt(prim[6 * LANES]));
}

FN void disk_block_w(const Ray* ray, GLOBAL const real* block, GLOBAL const int* ids, int slot, Nearest* best) {
  Disks_w disk;
  disk.center = load_planes3_w(block);
  disk.normal = load_planes3_w(block + 3 * LANES);
  disk.r2 = load_w(block + 6 * LANES);
  real3w o = splat3_w(ray->o);
  maskw which = is_there_w(ids);
#if TIER_COMPENSATED
  real3w f = sub3_w(o, disk.center);
  which = which & within_reach_w(ray, best, f.x, f.y, f.z, sqrt_w(disk.r2));
  if (!any_w(which)) return;
#endif
  realw t = disk_t_w(o, splat3_w(ray->d), &disk, splat_w(ray->t_min), splat_w(best->t), &which);
  take_nearest_w(which & in_range_w(t, ray, best), t, ids, TIER_FAST ? -1 : ray->departed, SHAPE_disk, slot, best);
}
