// SPDX-License-Identifier: MIT
// Ray against LANES disks, robust tier and double precision: what disk_hit_lanes.h says is hit gets the plane's t
// (plane_t_lanes.h). The disk that a ray has left or ends on is not asked for.

FN void disk_block_w(const Ray* ray, GLOBAL const real* block, GLOBAL const int* ids, int slot, Nearest* best) {
  real3w center = load_planes3_w(block), n = load_planes3_w(block + 3 * LANES), o = splat3_w(ray->o);
  real3w d = splat3_w(ray->d), f = sub3_w(o, center);
  realw r2 = load_w(block + 6 * LANES);
  maskw candidate = is_there_w(ids) & ~is_end_w(ids, ray) & within_reach_w(ray, best, f.x, f.y, f.z, sqrt_w(r2));
  if (!any_w(candidate)) return;
#if TIER_ROBUST
  maskw hit = disks_hit_w(o, d, center, n, r2, candidate);
  if (!any_w(hit)) return;
  realw rounded = plane_t_w(o, d, center, n, splat_w(ray->t_min), splat_w(best->t), hit);
#else
  maskw inside;
  dw3_w g = two_difference3_w(center.x, center.y, center.z, o.x, o.y, o.z);
  realw rounded = disks_met_w(g, n, d, r2, &inside).hi;
  maskw hit = candidate & inside;
#endif
  take_nearest_w(hit & in_range_w(rounded, ray, best), rounded, ids, -1, SHAPE_disk, slot, best);
}
