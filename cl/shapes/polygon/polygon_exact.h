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

/// The plane's t, correctly rounded; `approximate` where the ray is parallel to it.
FN real polygon_plane_t(const ExactRays_w* ray, real approximate, real3 a, real3 b, real3 c) {
  real least, most;
  polygon_range_w(ray, a, b, c, &least, &most);
  if (least == most) return least;
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

/// t of a polygon of 3 or 4 corners. t is always clamped to the polygon's range along the ray's largest axis. Where the
/// ray grazes the polygon, or the polygon is nearly a line, it is clamped to the polygon's box as well.
FN real polygon_exact_t(const Ray* ray, real approximate, GLOBAL const real* prim, int corners, int stride) {
  ExactRays_w one;
  exact_ray(ray, &one);
  real3 a = corner_of(prim, 0, stride), b = corner_of(prim, 1, stride), opposite = corner_of(prim, 2, stride);
  real3 c = corner_of(prim, corners - 1, stride);
  real t = polygon_plane_t(&one, approximate, a, b, c);
  if (!is_plain_w(&one, a, b, c)) t = within_box_of(ray, t, a, b, c, opposite);
  return within_polygon_w(&one, t, a, b, c, opposite);
}
