// SPDX-License-Identifier: MIT
// t of a flat polygon, robust tier, a ray and a polygon a lane. Which rays hit is decided by edge_lanes.h, in every
// tier. One width; no guard.

/// a d - b c of double words, up to 8 u^2 of |a d| + |b c|.
FN dw_w determinant_w(dw_w a, dw_w b, dw_w c, dw_w d) {
  dw_w p = two_prod_w(a.hi, d.hi), q = two_prod_w(b.hi, c.hi), s = two_sum_w(p.hi, -q.hi);
  realw of_a = fma_w(a.lo, d.hi, fma_w(a.hi, d.lo, p.lo)), of_b = fma_w(b.lo, c.hi, fma_w(b.hi, c.lo, q.lo));
  return two_sum_w(s.hi, s.lo + (of_a - of_b));
}

/// n.v of double words, up to 8 u^2 of the sum of absolute values.
FN dw_w dot_approximately_w(dw3_w n, dw3_w v) {
  dw_w x = two_prod_w(n.x.hi, v.x.hi), y = two_prod_w(n.y.hi, v.y.hi), z = two_prod_w(n.z.hi, v.z.hi);
  dw_w xy = two_sum_w(x.hi, y.hi), xyz = two_sum_w(xy.hi, z.hi);
  realw rest = (x.lo + y.lo + z.lo) + (xy.lo + xyz.lo);
  rest = rest + fma_w(n.z.lo, v.z.hi, fma_w(n.y.lo, v.y.hi, n.x.lo * v.x.hi));
  rest = rest + fma_w(n.z.hi, v.z.lo, fma_w(n.y.hi, v.y.lo, n.x.hi * v.x.lo));
  return two_sum_w(xyz.hi, rest);
}

/// The same for plain numbers. No term depends on d alone, because compilers would compute it for every ray.
FN dw_w dot_with_w(dw3_w n, real3w d) {
  dw_w x = two_prod_w(n.x.hi, d.x), y = two_prod_w(n.y.hi, d.y), z = two_prod_w(n.z.hi, d.z);
  dw_w xy = two_sum_w(x.hi, y.hi), xyz = two_sum_w(xy.hi, z.hi);
  realw rest = (x.lo + y.lo + z.lo) + (xy.lo + xyz.lo);
  return two_sum_w(xyz.hi, rest + fma_w(n.z.lo, d.z, fma_w(n.y.lo, d.y, n.x.lo * d.x)));
}

/// t where a ray meets the plane of the corners a, b, c: n.(g - o) / (n.d) with n = e x f = (b - a) x (c - a) and g the
/// corner nearest to the ray's point at `approximate`, since an error of n turns the plane about g; in double words,
/// rounded once. plain: lanes whose ray does not graze the polygon, and whose polygon is not nearly a line.
FN realw plane_t_w(const ExactRays_w* ray, realw approximate, real3w a, real3w b, real3w c, PRIVATE maskw* plain) {
  real3w near = fma3_w(approximate, ray->d, ray->o);
  dw3_w e = exact_difference_w(b, a), f = exact_difference_w(c, a), n;
  n.x = determinant_w(e.y, e.z, f.y, f.z);
  n.y = determinant_w(e.z, e.x, f.z, f.x);
  n.z = determinant_w(e.x, e.y, f.x, f.y);

  realw off_a = size1_w(sub3_w(a, near)), off_b = size1_w(sub3_w(b, near));
  realw off_c = size1_w(sub3_w(c, near));
  real3w g = sel3_w(lt_w(off_b, off_a), b, a);
  g = sel3_w(lt_w(off_c, off_a) & lt_w(off_c, off_b), c, g);
  dw_w n_g = dot_approximately_w(n, exact_difference_w(g, ray->o));
  dw_w n_d = dot_with_w(n, ray->d);
  realw inverse = splat_w(R(1.0)) / n_d.hi, q = n_g.hi * inverse;
  realw edges = size1_w(vec3_w(e.x.hi, e.y.hi, e.z.hi)) * size1_w(vec3_w(f.x.hi, f.y.hi, f.z.hi));
  *plain = ~lt_w(abs_w(n_d.hi), splat_w(R(0x1p-15)) * edges);
  return fma_w(fma_w(-q, n_d.hi, n_g.hi) + fma_w(-q, n_d.lo, n_g.lo), inverse, q);
}

/// Along each ray's largest axis.
FN realw ahead_w(const ExactRays_w* ray, real3w v) { return sel_w(ray->is_x, v.x, sel_w(ray->is_y, v.y, v.z)); }

/// t, clamped to the range of the polygon along the ray's largest axis. d: the fourth corner, or c again.
FN realw within_polygon_w(const ExactRays_w* ray, realw t, real3w a, real3w b, real3w c, real3w d) {
  realw za = ahead_w(ray, a), zb = ahead_w(ray, b), zc = ahead_w(ray, c), zd = ahead_w(ray, d);
  realw least = min_w(zd, min_w(zc, min_w(zb, za))), largest = max_w(zd, max_w(zc, max_w(zb, za)));
  realw o = ahead_w(ray, ray->o), one = (least - o) * ray->shear_z, other = (largest - o) * ray->shear_z;
  t = max_w(min_w(other, one), t);
  return min_w(max_w(other, one), t);
}

/// t of a triangle, to 4 ulp and mostly to 1/2: from the distance of o + approximate d from the plane, where the
/// triangle is so small compared with its distance that the roundings of e, f, n and that point, some u of |e| + |f|
/// over |n^.d|, do not matter. plain: lanes where that is so.
FN realw triangle_t_w(const ExactRays_w* ray, realw approximate, real3w a, real3w b, real3w c, PRIVATE maskw* plain) {
  real3w e = sub3_w(b, a), f = sub3_w(c, a), n = cross3_w(e, f), d = ray->d;
  dw3_w g = exact_difference_w(a, ray->o);
  realw x = fma_w(-approximate, d.x, g.x.hi) + g.x.lo, y = fma_w(-approximate, d.y, g.y.hi) + g.y.lo;
  realw z = fma_w(-approximate, d.z, g.z.hi) + g.z.lo, n_d = fma_w(n.z, d.z, fma_w(n.y, d.y, n.x * d.x));
  realw t = fma_w(fma_w(n.z, z, fma_w(n.y, y, n.x * x)), splat_w(R(1.0)) / n_d, approximate);
  realw edges = size1_w(e) + size1_w(f);
  *plain = le_w(splat_w(R(4.0)) * edges * size1_w(n), abs_w(t * n_d));
  return t;
}
