// SPDX-License-Identifier: MIT
// t of flat polygons in the robust tier, one width; no guard. Which rays hit is decided by edge_lanes.h, in every tier.

/// L1 norm of p - q.
FN realw LANED(apart)(realw px, realw py, realw pz, realw qx, realw qy, realw qz) {
  return abs_w(px - qx) + abs_w(py - qy) + abs_w(pz - qz);
}

/// t where the ray meets the plane of three corners, each three planes of LANES reals: n.(a - o) / (n.d) with
/// n = (b - a) x (c - a), differences exact, products in double words, rounded once. Error below 1 ulp, but for what
/// cancels in n and n.d: least with a, whichever it is given as, the corner of the least |a - o| over the length of the
/// edge across, which a needle's far tip is not. Then held within [z_min, z_max], the polygon's range along the ray's
/// largest axis.
FN realw LANED(polygon_t)(const Ray* ray, GLOBAL const real* a, GLOBAL const real* b, GLOBAL const real* c, realw z_min,
                          realw z_max) {
  realw ax = load_w(a), ay = load_w(a + LANES), az = load_w(a + 2 * LANES);
  realw bx = load_w(b), by = load_w(b + LANES), bz = load_w(b + 2 * LANES);
  realw cx = load_w(c), cy = load_w(c + LANES), cz = load_w(c + 2 * LANES);
  realw ox = splat_w(ray->o.x), oy = splat_w(ray->o.y), oz = splat_w(ray->o.z);
  realw away = LANED(apart)(ax, ay, az, ox, oy, oz), across = LANED(apart)(bx, by, bz, cx, cy, cz);
  realw across_b = LANED(apart)(ax, ay, az, cx, cy, cz), across_c = LANED(apart)(ax, ay, az, bx, by, bz);
  realw away_b = LANED(apart)(bx, by, bz, ox, oy, oz), away_c = LANED(apart)(cx, cy, cz, ox, oy, oz);
  maskw at_b = lt_w(away_b * across, away * across_b);
  away = sel_w(at_b, away_b, away);
  across = sel_w(at_b, across_b, across);
  maskw at_c = lt_w(away_c * across, away * across_c);
  realw gx = sel_w(at_c, cx, sel_w(at_b, bx, ax)), gy = sel_w(at_c, cy, sel_w(at_b, by, ay));
  realw gz = sel_w(at_c, cz, sel_w(at_b, bz, az));
  realw ex = sel_w(at_c, ax, sel_w(at_b, cx, bx)), ey = sel_w(at_c, ay, sel_w(at_b, cy, by));
  realw ez = sel_w(at_c, az, sel_w(at_b, cz, bz));
  realw fx = sel_w(at_c, bx, sel_w(at_b, ax, cx)), fy = sel_w(at_c, by, sel_w(at_b, ay, cy));
  realw fz = sel_w(at_c, bz, sel_w(at_b, az, cz));
  dw3_w e = two_difference3_w(ex, ey, ez, gx, gy, gz), f = two_difference3_w(fx, fy, fz, gx, gy, gz);
  dw3_w n;
  n.x = dw_add_w(dw_mul_w(e.y, f.z), dw_negate_w(dw_mul_w(e.z, f.y)));
  n.y = dw_add_w(dw_mul_w(e.z, f.x), dw_negate_w(dw_mul_w(e.x, f.z)));
  n.z = dw_add_w(dw_mul_w(e.x, f.y), dw_negate_w(dw_mul_w(e.y, f.x)));
  dw3_w g = two_difference3_w(gx, gy, gz, ox, oy, oz);
  dw_w n_d = dot_real3_w(n, splat_w(ray->d.x), splat_w(ray->d.y), splat_w(ray->d.z));
  realw t = dw_div_w(dw_dot3_w(n, g), n_d).hi;
  realw axis = splat_w(component(ray->d, ray->kz));
  realw one = z_min / axis, other = z_max / axis;
  realw first = min_w(one, other), last = max_w(one, other);
  t = sel_w(lt_w(t, first), first, t);
  return sel_w(lt_w(last, t), last, t);
}
