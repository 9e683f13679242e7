// SPDX-License-Identifier: MIT
// t of a flat polygon, robust tier, one lane. Which rays hit is decided by edge_lanes.h, in every tier.

/// a d - b c of double words, up to 8 u^2 of |a d| + |b c|.
FN dw_w determinant(dw_w a, dw_w b, dw_w c, dw_w d) {
  dw_w p = two_prod_w(a.hi, d.hi), q = two_prod_w(b.hi, c.hi), s = two_sum_w(p.hi, -q.hi);
  real of_a = fma_w(a.lo, d.hi, fma_w(a.hi, d.lo, p.lo)), of_b = fma_w(b.lo, c.hi, fma_w(b.hi, c.lo, q.lo));
  return two_sum_w(s.hi, s.lo + (of_a - of_b));
}

/// n.v of double words, up to 8 u^2 of the sum of absolute values.
FN dw_w dot_roughly(dw3_w n, dw3_w v) {
  dw_w x = two_prod_w(n.x.hi, v.x.hi), y = two_prod_w(n.y.hi, v.y.hi), z = two_prod_w(n.z.hi, v.z.hi);
  dw_w xy = two_sum_w(x.hi, y.hi), xyz = two_sum_w(xy.hi, z.hi);
  real rest = (x.lo + y.lo + z.lo) + (xy.lo + xyz.lo);
  rest = rest + fma_w(n.z.lo, v.z.hi, fma_w(n.y.lo, v.y.hi, n.x.lo * v.x.hi));
  rest = rest + fma_w(n.z.hi, v.z.lo, fma_w(n.y.hi, v.y.lo, n.x.hi * v.x.lo));
  return two_sum_w(xyz.hi, rest);
}

/// The same with numbers: nothing is computed of d alone, which compilers would do for every ray.
FN dw_w dot_with(dw3_w n, real3 d) {
  dw_w x = two_prod_w(n.x.hi, d.x), y = two_prod_w(n.y.hi, d.y), z = two_prod_w(n.z.hi, d.z);
  dw_w xy = two_sum_w(x.hi, y.hi), xyz = two_sum_w(xy.hi, z.hi);
  real rest = (x.lo + y.lo + z.lo) + (xy.lo + xyz.lo);
  return two_sum_w(xyz.hi, rest + fma_w(n.z.lo, d.z, fma_w(n.y.lo, d.y, n.x.lo * d.x)));
}

/// For files of other widths, whose dw3_w is another.
typedef dw3_w Exact3;

FN dw3_w exact_difference(real3 p, real3 q) { return two_difference3_w(p.x, p.y, p.z, q.x, q.y, q.z); }

FN real size1(real3 v) { return real_abs(v.x) + real_abs(v.y) + real_abs(v.z); }

/// The least and the largest of a component of four corners.
FN void corner_range(GLOBAL const real* a, GLOBAL const real* b, GLOBAL const real* c, GLOBAL const real* d, int at,
                     PRIVATE real* least, PRIVATE real* largest) {
  *least = min_w(d[at], min_w(c[at], min_w(b[at], a[at])));
  *largest = max_w(d[at], max_w(c[at], max_w(b[at], a[at])));
}

/// t where the ray meets the plane of the corners a, b, c (planes x y z, `stride` apart): n.(g - o) / (n.d) with
/// n = e x f = (b - a) x (c - a) and g the corner nearest to where the ray passes, about `rough`, since an error of n
/// turns the plane about g; in double words, rounded once. Where the ray grazes the polygon, or that is all but a line,
/// t is held within its slabs, and always within its range along the ray's largest axis. d: the fourth corner, or c
/// again.
FN real polygon_t(const Ray* ray, real rough, GLOBAL const real* a, GLOBAL const real* b, GLOBAL const real* c,
                  GLOBAL const real* d, int stride) {
  real3 pa = vec3(a[0], a[stride], a[2 * stride]), pb = vec3(b[0], b[stride], b[2 * stride]);
  real3 pc = vec3(c[0], c[stride], c[2 * stride]), near = fma3(rough, ray->d, ray->o);
  dw3_w e = exact_difference(pb, pa), f = exact_difference(pc, pa), n;
  n.x = determinant(e.y, e.z, f.y, f.z);
  n.y = determinant(e.z, e.x, f.z, f.x);
  n.z = determinant(e.x, e.y, f.x, f.y);

  real off_a = size1(sub3(pa, near)), off_b = size1(sub3(pb, near)), off_c = size1(sub3(pc, near));
  real3 g = off_b < off_a ? pb : pa;
  g = off_c < off_a && off_c < off_b ? pc : g;
  dw_w n_g = dot_roughly(n, exact_difference(g, ray->o));
  dw_w n_d = dot_with(n, ray->d);
  real inverse = R(1.0) / n_d.hi, q = n_g.hi * inverse;
  real t = fma_w(fma_w(-q, n_d.hi, n_g.hi) + fma_w(-q, n_d.lo, n_g.lo), inverse, q);

  real edges = size1(vec3(e.x.hi, e.y.hi, e.z.hi)) * size1(vec3(f.x.hi, f.y.hi, f.z.hi));
  if (real_abs(n_d.hi) < R(0x1p-15) * edges) {
    real lo[3], hi[3];
    for (int axis = 0; axis < 3; ++axis) corner_range(a, b, c, d, axis * stride, lo + axis, hi + axis);
    t = LANED(within_slabs)(ray, t, lo[0], hi[0], lo[1], hi[1], lo[2], hi[2]);
  }
  real least, largest, o = component(ray->o, ray->kz);
  corner_range(a, b, c, d, ray->kz * stride, &least, &largest);
  real one = (least - o) * ray->shear_z, other = (largest - o) * ray->shear_z;
  t = max_w(min_w(other, one), t);
  return min_w(max_w(other, one), t);
}

/// The same of a triangle, to 4 ulp and mostly to 1/2: from how far o + rough d is off the plane, where the triangle is
/// so small beside its distance that the roundings of e, f, n and that point, some u of |e| + |f| over |n^.d|, do not
/// matter. 0: it is not.
FN int triangle_t(const Ray* ray, real rough, GLOBAL const real* a, GLOBAL const real* b, GLOBAL const real* c,
                  int stride, PRIVATE real* found) {
  real3 pa = vec3(a[0], a[stride], a[2 * stride]), pb = vec3(b[0], b[stride], b[2 * stride]);
  real3 pc = vec3(c[0], c[stride], c[2 * stride]), e = sub3(pb, pa), f = sub3(pc, pa), n = cross3(e, f);
  dw3_w g = exact_difference(pa, ray->o);
  real x = fma_w(-rough, ray->d.x, g.x.hi) + g.x.lo, y = fma_w(-rough, ray->d.y, g.y.hi) + g.y.lo;
  real z = fma_w(-rough, ray->d.z, g.z.hi) + g.z.lo;
  real n_d = fma_w(n.z, ray->d.z, fma_w(n.y, ray->d.y, n.x * ray->d.x));
  real t = fma_w(fma_w(n.z, z, fma_w(n.y, y, n.x * x)), R(1.0) / n_d, rough);
  *found = t;
  return R(4.0) * (size1(e) + size1(f)) * size1(n) <= real_abs(t * n_d);
}
