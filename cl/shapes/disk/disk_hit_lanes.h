// SPDX-License-Identifier: MIT
// Which rays meet disks, robust tier and double precision: t of the plane as a double word, and with it the sign of r^2
// - |p - c|^2, where p - c = t d - (c - o). In the robust tier single precision tells most rays. A ray and a disk a
// lane, for blocks and for packets. One width; no guard.

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

#if TIER_ROBUST
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

/// The lanes of `which` whose rays meet the plane within the disk, a ray and a disk a lane.
FN maskw disks_hit_w(real3w o, real3w d, real3w center, real3w n, realw r2, maskw which) {
  maskw told, outside, inside;
  disks_told_w(sub3_w(center, o), n, d, r2, &told, &outside);
  maskw hit = which & told, open = which & ~(told | outside);
  if (any_w(open)) {
    (void)disks_met_w(two_difference3_w(center.x, center.y, center.z, o.x, o.y, o.z), n, d, r2, &inside);
    hit = hit | (open & inside);
  }
  return hit;
}
#endif
