// SPDX-License-Identifier: MIT
// t of a flat polygon, robust tier, a ray and a polygon a lane: where the ray meets the plane of the corners a, b, c,
// correctly rounded, held within the polygon's own range. Which rays hit is decided by edge_lanes.h, in every tier. One
// width; no guard.

/// The same corners in their order, beginning with the one between the two shorter edges: the product of their lengths
/// bounds what is lost in the normal. That of a needle's tip would be as many times as large as the needle is long.
FN void begin_at_short_edges_w(PRIVATE real3w* a, PRIVATE real3w* b, PRIVATE real3w* c) {
  realw ab = size1_w(sub3_w(*b, *a)), bc = size1_w(sub3_w(*c, *b)), ca = size1_w(sub3_w(*a, *c));
  maskw at_b = lt_w(bc, ca) & le_w(ab, ca), at_c = lt_w(bc, ab) & lt_w(ca, ab);
  real3w p = *a, q = *b, r = *c;
  *a = sel3_w(at_c, r, sel3_w(at_b, q, p));
  *b = sel3_w(at_c, p, sel3_w(at_b, r, q));
  *c = sel3_w(at_c, q, sel3_w(at_b, p, r));
}

/// The components of e x f with absolute values added instead of subtracted: roundings change e x f by shares of these.
/// 2^-95 stands for what underflow does to double words.
FN real3w cross_size_w(real3w e, real3w f) {
  real3w p = abs3_w(e), q = abs3_w(f);
  realw tiny = splat_w(R(0x1p-95));
  return vec3_w(fma_w(p.y, q.z, fma_w(p.z, q.y, tiny)), fma_w(p.z, q.x, fma_w(p.x, q.z, tiny)),
                fma_w(p.x, q.y, fma_w(p.y, q.x, tiny)));
}

/// A range that the correctly rounded t of the plane certainly lies in, mostly a single number; NaN where nothing is
/// known. t = n.g / (n.d), n = e x f, e = b - a, f = c - a, g = a - o. With w the roundoff of what is wide and N =
/// cross_size, each n_i is within 4 w N_i, so n.g is within 8 w N.|g| and n.d within 7 w N.|d|; t is within
/// 20 w (N.|g| + |t| N.|d|) / |n.d| where 64 w N.|d| < |n.d|. Axis by axis: of a floor N and |g| are large along
/// different axes, so t is known to a few w of itself where a ray begins next to it. What underflow does to double
/// words is less than 2^-140, and to a quotient that is not 0 less than 2^-120.
INLINE_FN void polygon_range_w(const ExactRays_w* ray, real3w a, real3w b, real3w c, PRIVATE realw* least,
                               PRIVATE realw* most) {
  begin_at_short_edges_w(&a, &b, &c);
  wide3_w e = wide_difference3_w(b, a), f = wide_difference3_w(c, a), n;
  n.x = wide_determinant_w(e.y, e.z, f.y, f.z);
  n.y = wide_determinant_w(e.z, e.x, f.z, f.x);
  n.z = wide_determinant_w(e.x, e.y, f.x, f.y);
  wide_w n_d = wide_dot_w(n, ray->d);
  wide_w t = wide_divide_w(wide_dot3_w(n, wide_difference3_w(a, ray->o)), n_d);
  real3w sizes = cross_size_w(sub3_w(b, a), sub3_w(c, a));
  realw along = dot3_w(sizes, abs3_w(ray->d)), scale = splat_w(R(0x1p-90)), lost = splat_w(R(32.0) * WIDE_ROUNDOFF);
  realw size = fma_w(abs_w(narrow_w(t)), along, dot3_w(sizes, abs3_w(sub3_w(a, ray->o)))) + scale;
  realw across = abs_w(narrow_w(n_d)), off = lost * size * (splat_w(R(1.0)) / across), zero = splat_w(R(0.0));
  off = off + sel_w(eq_w(narrow_w(t), zero), zero, splat_w(R(0x1p-120)));
  maskw is_known = lt_w(lost * (along + along), across) & lt_w(scale, across) & lt_w(across, splat_w(R(0x1p+120)));
  wide_range_w(t, off, is_known, least, most);
}

/// Lanes whose ray does not graze the polygon, and whose polygon is not nearly a line.
FN maskw is_plain_w(const ExactRays_w* ray, real3w a, real3w b, real3w c) {
  real3w e = sub3_w(b, a), f = sub3_w(c, a);
  return le_w(splat_w(R(0x1p-15)) * size1_w(e) * size1_w(f), abs_w(dot3_w(cross3_w(e, f), ray->d)));
}

/// Along each ray's largest axis.
FN realw ahead_w(const ExactRays_w* ray, real3w v) { return sel_w(ray->is_x, v.x, sel_w(ray->is_y, v.y, v.z)); }

/// t, clamped to the range of the polygon along the ray's largest axis, and what that is off by itself, which is less
/// than 2^-22 of it. d: the fourth corner, or c again.
FN realw within_polygon_w(const ExactRays_w* ray, realw t, real3w a, real3w b, real3w c, real3w d) {
  realw za = ahead_w(ray, a), zb = ahead_w(ray, b), zc = ahead_w(ray, c), zd = ahead_w(ray, d);
  realw least = min_w(zd, min_w(zc, min_w(zb, za))), largest = max_w(zd, max_w(zc, max_w(zb, za)));
  realw o = ahead_w(ray, ray->o), one = (least - o) * ray->shear_z, other = (largest - o) * ray->shear_z;
  realw spare = splat_w(R(0x1p-22)) * max_w(abs_w(other), abs_w(one));
  t = max_w(min_w(other, one) - spare, t);
  return min_w(max_w(other, one) + spare, t);
}

/// Lanes in which every t up to `most` is before t_min, which is all that matters of it: where a camera stands in the
/// plane of a wall, t is 0 or so for all of its rays. Not known where `most` is a NaN.
FN maskw is_before_w(const ExactRays_w* ray, realw most, real3w a, real3w b, real3w c, real3w d) {
  return lt_w(most, ray->t_min) & lt_w(within_polygon_w(ray, most, a, b, c, d), ray->t_min);
}
