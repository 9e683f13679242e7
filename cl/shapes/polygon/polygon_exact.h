// SPDX-License-Identifier: MIT
// polygon_exact_lanes.h for one ray and one polygon in a block, robust tier, one lane. prim: the polygon's own planes,
// `stride` apart.

FN real3 corner_of(GLOBAL const real* prim, int corner, int stride) {
  GLOBAL const real* at = prim + 3 * corner * stride;
  return vec3(at[0], at[stride], at[2 * stride]);
}

/// t, clamped to the box of four corners.
FN real within_box_of(const Ray* ray, real t, real3 a, real3 b, real3 c, real3 d) {
  real3 lo = vec3(min_w(d.x, min_w(c.x, min_w(b.x, a.x))), min_w(d.y, min_w(c.y, min_w(b.y, a.y))),
                  min_w(d.z, min_w(c.z, min_w(b.z, a.z))));
  real3 hi = vec3(max_w(d.x, max_w(c.x, max_w(b.x, a.x))), max_w(d.y, max_w(c.y, max_w(b.y, a.y))),
                  max_w(d.z, max_w(c.z, max_w(b.z, a.z))));
  return within_slabs_w(ray, t, lo.x, hi.x, lo.y, hi.y, lo.z, hi.z);
}

FN int same_bits(real x, real y) { return real_to_bits(x) == real_to_bits(y); }

/// 1: n.(a - o) is certainly 0, n = (b - a) x (c - a): along each axis n or a - o is. So where a camera stands in the
/// plane of a wall, or blocks on a floor, if they are parallel to the axes. 0: it need not be.
FN int is_in_plane(real3 o, real3 a, real3 b, real3 c) {
  int ab_x = same_bits(a.x, b.x), ab_y = same_bits(a.y, b.y), ab_z = same_bits(a.z, b.z);
  int ac_x = same_bits(a.x, c.x), ac_y = same_bits(a.y, c.y), ac_z = same_bits(a.z, c.z);
  return (same_bits(a.x, o.x) | ((ab_y | ac_z) & (ab_z | ac_y))) &
         (same_bits(a.y, o.y) | ((ab_z | ac_x) & (ab_x | ac_z))) &
         (same_bits(a.z, o.z) | ((ab_x | ac_y) & (ab_y | ac_x)));
}

/// The plane's t, correctly rounded, within its range; `approximate` where the ray is parallel to it.
FN real polygon_plane_t(const ExactRays_w* ray, real approximate, real least, real most, real3 a, real3 b, real3 c) {
  if (least == most) return least;
  if (least <= R(0.0) && R(0.0) <= most && is_in_plane(ray->o, a, b, c)) return R(0.0);
  ExactCase one;
  one.o = ray->o;
  one.d = ray->d;
  one.a = a;
  one.b = b;
  one.c = c;
  one.r = R(0.0);
  real t = exact_polygon_t(&one, least, most);
  return real_is_finite(t) ? t : approximate;
}

/// t of a polygon of 3 or 4 corners, any t before t_min where it is before t_min. t is always clamped to the polygon's
/// range along the ray's largest axis. Where the ray grazes the polygon, or the polygon is nearly a line, it is clamped
/// to the polygon's box as well.
FN real polygon_exact_t(const Ray* ray, real approximate, GLOBAL const real* prim, int corners, int stride) {
  ExactRays_w one;
  exact_ray(ray, &one);
  real3 a = corner_of(prim, 0, stride), b = corner_of(prim, 1, stride), opposite = corner_of(prim, 2, stride);
  real3 c = corner_of(prim, corners - 1, stride);
  real least, most;
  polygon_range_w(&one, a, b, c, &least, &most);
  maskw is_plain = is_plain_w(&one, a, b, c);
  real t = most;
  if (!(is_plain & is_before_w(&one, most, a, b, c, opposite)))
    t = polygon_plane_t(&one, approximate, least, most, a, b, c);
  if (!is_plain) t = within_box_of(ray, t, a, b, c, opposite);
  return within_polygon_w(&one, t, a, b, c, opposite);
}
