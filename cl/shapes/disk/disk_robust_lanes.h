// SPDX-License-Identifier: MIT
// Ray against LANES disks, robust tier and double precision: t of the plane as a double word, and with it the sign of
// r^2 - |p - c|^2, where p - c = t d - (c - o). What is hit then gets the plane's t (plane_t_lanes.h). The disk that a
// ray has left is not asked for, as in plane_robust_lanes.h. In the robust tier single precision tells most rays.

/// Lanes whose rays meet the plane surely inside the disk and surely outside it. g: c - o, rounded. With |.| the sum of
/// absolute values and u = 2^-24, n.g and n.d are off by less than 4 u |n| |g| and 3 u |n| |d|, so p by less than 16 u
/// |n| |d| (|g| + |t| |d|) / |n.d| where n.d is not mostly rounding; 2^-18 is 64 u, and 2^-100 far above what underflow
/// does. The same of r is more than the rounding of r and |p|. A NaN is neither.
FN void disks_told_w(real3w g, real3w n, real3w d, realw r2, PRIVATE maskw* inside, PRIVATE maskw* outside) {
  realw some = splat_w(R(0x1p-18)), n_d = dot3_w(n, d), t = dot3_w(n, g) / n_d, r = sqrt_w(r2), size_d = size1_w(d);
  real3w p = fma3_w(t, d, negate3_w(g));
  realw size_n = size1_w(n), lost = some * size_n * fma_w(abs_w(t), size_d, size1_w(g)) + splat_w(R(0x1p-100));
  realw off = fma_w(lost / abs_w(n_d), size_d, some * r), within = r - off, beyond = r + off, p2 = dot3_w(p, p);
  maskw is_sound = lt_w(splat_w(R(0x1p-80)), r2) & lt_w(fma_w(some * size_n, size_d, splat_w(R(0x1p-100))), abs_w(n_d));
  *inside = is_sound & lt_w(splat_w(R(0.0)), within) & lt_w(p2, within * within);
  *outside = is_sound & lt_w(beyond * beyond, p2);
}

/// t of the planes, and the lanes whose rays meet them within the disks.
FN dw_w disks_met_w(dw3_w g, real3w n, real3w d, realw r2, PRIVATE maskw* inside) {
  dw_w t = dw_div_w(dot_real3_w(g, n.x, n.y, n.z), real_dot_real3_w(n.x, n.y, n.z, d.x, d.y, d.z));
  dw3_w p;
  p.x = dw_add_w(dw_scale_w(t, d.x), dw_negate_w(g.x));
  p.y = dw_add_w(dw_scale_w(t, d.y), dw_negate_w(g.y));
  p.z = dw_add_w(dw_scale_w(t, d.z), dw_negate_w(g.z));
  dw_w squared = dw_dot3_w(p, p);
  // The difference of two numbers keeps its sign when rounded; r2 - hi is exact where it matters.
  *inside = le_w(squared.lo, r2 - squared.hi);
  return t;
}

FN void disk_block_w(const Ray* ray, GLOBAL const real* block, GLOBAL const int* ids, int slot, Nearest* best) {
  dw3_w g = two_difference3_w(load_w(block), load_w(block + LANES), load_w(block + 2 * LANES), splat_w(ray->o.x),
                              splat_w(ray->o.y), splat_w(ray->o.z));
  real3w n = load_planes3_w(block + 3 * LANES), d = splat3_w(ray->d);
  realw r2 = load_w(block + 6 * LANES);
  maskw candidate = is_another_w(ids, ray) & within_reach_w(ray, best, -g.x.hi, -g.y.hi, -g.z.hi, sqrt_w(r2)), inside;
  if (!any_w(candidate)) return;
#if TIER_ROBUST
  maskw told, outside;
  disks_told_w(vec3_w(g.x.hi, g.y.hi, g.z.hi), n, d, r2, &told, &outside);
  maskw hit = candidate & told, open = candidate & ~(told | outside);
  if (any_w(open)) {
    (void)disks_met_w(g, n, d, r2, &inside);
    hit = hit | (open & inside);
  }
  if (!any_w(hit)) return;
  realw rounded = plane_t_w(splat3_w(ray->o), d, load_planes3_w(block), n, splat_w(ray->t_min), splat_w(best->t), hit);
#else
  realw rounded = disks_met_w(g, n, d, r2, &inside).hi;
  maskw hit = candidate & inside;
#endif
  take_nearest_w(hit & in_range_w(rounded, ray, best), rounded, ids, ray->departed, SHAPE_disk, slot, best);
}
