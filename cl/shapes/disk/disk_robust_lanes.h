// SPDX-License-Identifier: MIT
// Ray against LANES disks, robust tier and double precision: t of the plane as a double word, and with it the sign of
// r^2 - |p - c|^2, where p - c = t d - (c - o). What is hit then gets the plane's t (plane_t_lanes.h). The disk that a
// ray has left is not asked for, as in plane_robust_lanes.h.

FN void disk_block_w(const Ray* ray, GLOBAL const real* block, GLOBAL const int* ids, int slot, Nearest* best) {
  dw3_w g = two_difference3_w(load_w(block), load_w(block + LANES), load_w(block + 2 * LANES), splat_w(ray->o.x),
                              splat_w(ray->o.y), splat_w(ray->o.z));
  realw r2 = load_w(block + 6 * LANES);
  maskw candidate = is_another_w(ids, ray) & within_reach_w(ray, best, -g.x.hi, -g.y.hi, -g.z.hi, sqrt_w(r2));
  if (!any_w(candidate)) return;

  realw nx = load_w(block + 3 * LANES), ny = load_w(block + 4 * LANES), nz = load_w(block + 5 * LANES);
  realw dx = splat_w(ray->d.x), dy = splat_w(ray->d.y), dz = splat_w(ray->d.z);
  dw_w t = dw_div_w(dot_real3_w(g, nx, ny, nz), real_dot_real3_w(nx, ny, nz, dx, dy, dz));
  dw3_w p;
  p.x = dw_add_w(dw_scale_w(t, dx), dw_negate_w(g.x));
  p.y = dw_add_w(dw_scale_w(t, dy), dw_negate_w(g.y));
  p.z = dw_add_w(dw_scale_w(t, dz), dw_negate_w(g.z));
  dw_w squared = dw_dot3_w(p, p);
  // The difference of two numbers keeps its sign when rounded; r2 - hi is exact where it matters.
  maskw hit = candidate & le_w(squared.lo, r2 - squared.hi);
#if TIER_ROBUST
  realw rounded = plane_t_w(splat3_w(ray->o), splat3_w(ray->d), load_planes3_w(block), vec3_w(nx, ny, nz),
                            splat_w(ray->t_min), splat_w(best->t), hit);
#else
  realw rounded = t.hi;
#endif
  take_nearest_w(hit & in_range_w(rounded, ray, best), rounded, ids, ray->departed, SHAPE_disk, slot, best);
}
