// SPDX-License-Identifier: MIT
// Rays against disks, robust tier and double precision: t of the plane as a double word, and with it the sign of
// r^2 - |p - c|^2, p - c = t d - (c - o). What is hit then gets the plane's t (plane_t_lanes.h).

/// t of the lanes of `which` whose line meets the disk, which are left in it. A ray and a disk a lane. t_min, t_max: in
/// the robust tier t outside of them is undefined.
FN realw disk_t_w(real3w o, real3w d, const Disks_w* disk, realw t_min, realw t_max, PRIVATE maskw* which) {
  real3w c = disk->center, n = disk->normal;
  dw3_w g = two_difference3_w(c.x, c.y, c.z, o.x, o.y, o.z);
  dw_w t = dw_div_w(dot_real3_w(g, n.x, n.y, n.z), real_dot_real3_w(n.x, n.y, n.z, d.x, d.y, d.z));
  dw3_w p;
  p.x = dw_add_w(dw_scale_w(t, d.x), dw_negate_w(g.x));
  p.y = dw_add_w(dw_scale_w(t, d.y), dw_negate_w(g.y));
  p.z = dw_add_w(dw_scale_w(t, d.z), dw_negate_w(g.z));
  dw_w squared = dw_dot3_w(p, p);
  // The difference of two numbers keeps its sign when rounded; r2 - hi is exact where it matters.
  *which = *which & le_w(squared.lo, disk->r2 - squared.hi);
#if TIER_ROBUST
  return plane_t_w(o, d, c, n, t_min, t_max, *which);
#else
  (void)t_min;
  (void)t_max;
  return t.hi;
#endif
}
