// SPDX-License-Identifier: MIT
// t of flat polygons in the robust tier, one width; no guard. Which rays hit is decided by edge_lanes.h, in every tier.

/// t where the ray meets the plane of three corners, each three planes of LANES reals: n.(a - o) / (n.d) with
/// n = (b - a) x (c - a), differences exact, products in double words, rounded once. Error below 1 ulp, but for what
/// cancels in n and n.d. Then held within [z_min, z_max], the polygon's range along the ray's largest axis.
FN realw LANED(polygon_t)(const Ray* ray, GLOBAL const real* a, GLOBAL const real* b, GLOBAL const real* c, realw z_min,
                          realw z_max) {
  realw ax = load_w(a), ay = load_w(a + LANES), az = load_w(a + 2 * LANES);
  dw3_w e = two_difference3_w(load_w(b), load_w(b + LANES), load_w(b + 2 * LANES), ax, ay, az);
  dw3_w f = two_difference3_w(load_w(c), load_w(c + LANES), load_w(c + 2 * LANES), ax, ay, az);
  dw3_w n;
  n.x = dw_add_w(dw_mul_w(e.y, f.z), dw_negate_w(dw_mul_w(e.z, f.y)));
  n.y = dw_add_w(dw_mul_w(e.z, f.x), dw_negate_w(dw_mul_w(e.x, f.z)));
  n.z = dw_add_w(dw_mul_w(e.x, f.y), dw_negate_w(dw_mul_w(e.y, f.x)));
  dw3_w g = two_difference3_w(ax, ay, az, splat_w(ray->o.x), splat_w(ray->o.y), splat_w(ray->o.z));
  dw_w n_d = dot_real3_w(n, splat_w(ray->d.x), splat_w(ray->d.y), splat_w(ray->d.z));
  realw t = dw_div_w(dw_dot3_w(n, g), n_d).hi;
  realw axis = splat_w(component(ray->d, ray->kz));
  realw one = z_min / axis, other = z_max / axis;
  realw first = min_w(one, other), last = max_w(one, other);
  t = sel_w(lt_w(t, first), first, t);
  return sel_w(lt_w(last, t), last, t);
}
