// SPDX-License-Identifier: MIT
// Rays against open cylinders, robust tier: the sphere's form in two dimensions, for f x v and d x v instead of f
// and d, v the axis. v is a unit vector that was rounded; the rounded one is taken as exact. The mantle is |f x v| = r
// |v|, from (p - p0).v = 0 to length v.v, so neither radius nor direction depends on |v| being 1.
// (f x v) x (d x v) = (f . (d x v)) v, hence the discriminant is v.v times a r^2 - (f . (d x v))^2.
// A ray parallel to the axis misses. The cylinder just left: the other root, -2 b / a.

typedef struct {
  maskw which;       ///< Lanes that hit,
  dw_w t;            ///< and where, as a double word.
  maskw is_near;     ///< Lanes whose t is the near root.
  realw a;           ///< |d x v|^2.
  realw half_chord;  ///< In units of t.
} CylinderHits_w;

/// Lanes whose axis the line may pass within r. Distance times |d x v|, all off by less than 16 u; NaN passes. f: o -
/// foot.
FN maskw near_axis_w(real3w d, real3w f, real3w v, realw r) {
  realw nx = difference_of_products_w(d.y, v.z, d.z, v.y);
  realw ny = difference_of_products_w(d.z, v.x, d.x, v.z);
  realw nz = difference_of_products_w(d.x, v.y, d.y, v.x);
  realw distance = fma_w(f.z, nz, fma_w(f.y, ny, f.x * nx));
  realw limit = fma_w(splat_w(R(0x1p-19)), abs_w(f.x) + abs_w(f.y) + abs_w(f.z), r);
  realw squared = limit * limit * fma_w(nz, nz, fma_w(ny, ny, nx * nx)) + splat_w(R(0x1p-120));
  return ~lt_w(squared, distance * distance);
}

/// The lanes of `which` that hit, and those of `departed` that hit the cylinder that they have left. A ray and a
/// cylinder a lane.
FN CylinderHits_w cylinder_hits_w(real3w o, real3w d, const Cylinders_w* cylinder, realw t_min, maskw which,
                                  maskw departed) {
  CylinderHits_w hits;
  real3w foot = cylinder->foot, v = cylinder->axis;
  realw r = cylinder->r, zero = splat_w(R(0.0));
  dw3_w f = two_difference3_w(o.x, o.y, o.z, foot.x, foot.y, foot.z);
  hits.which = which & near_axis_w(d, vec3_w(f.x.hi, f.y.hi, f.z.hi), v, r);
  hits.is_near = none_w();
  hits.a = hits.half_chord = hits.t.hi = hits.t.lo = zero;
  if (!any_w(hits.which | departed)) return hits;

  dw3_w across, from = cross_real3_w(f, v.x, v.y, v.z);
  across.x = sum3_round_w(sum3_begin_w(d.y, v.z, -d.z, v.y));
  across.y = sum3_round_w(sum3_begin_w(d.z, v.x, -d.x, v.z));
  across.z = sum3_round_w(sum3_begin_w(d.x, v.y, -d.y, v.x));
  dw_w v2 = real_dot_real3_w(v.x, v.y, v.z, v.x, v.y, v.z), r2 = two_prod_w(r, r);
  dw_w a = dw_dot3_w(across, across), b = dw_dot3_w(from, across), apart = dw_dot3_w(f, across);
  dw_w c = dw_add_w(dw_dot3_w(from, from), dw_negate_w(dw_mul_w(r2, v2)));
  dw_w discriminant = dw_mul_w(v2, dw_add_w(dw_mul_w(a, r2), dw_negate_w(dw_mul_w(apart, apart))));
  maskw hit = hits.which & le_w(zero, discriminant.hi) & lt_w(zero, a.hi);

  Roots_w roots = quadratic_roots_w(a, b, c, discriminant);
  dw_w o_along = dot_real3_w(f, v.x, v.y, v.z), d_along = real_dot_real3_w(d.x, d.y, d.z, v.x, v.y, v.z);
  dw_w end = dw_negate_w(dw_scale_w(v2, cylinder->length));
  dw_w along = dw_add_w(o_along, dw_mul_w(roots.near, d_along));
  hits.is_near = le_w(t_min, roots.near.hi) & le_w(zero, along.hi) & le_w(dw_add_w(along, end).hi, zero);
  hits.t = dw_sel_w(hits.is_near, roots.near, roots.far);

  dw_w other = dw_scale_w(dw_div_w(b, a), splat_w(-R(2.0)));
  hits.t = dw_sel_w(departed, other, hits.t);
  along = dw_add_w(o_along, dw_mul_w(hits.t, d_along));
  hit = (hit & ~departed) | (departed & lt_w(zero, other.hi));
  hits.which = hit & le_w(zero, along.hi) & le_w(dw_add_w(along, end).hi, zero);
  hits.a = a.hi;
  hits.half_chord = sqrt_w(discriminant.hi) / a.hi;
  return hits;
}

/// t, not correctly rounded yet.
FN realw cylinder_about_w(const CylinderHits_w* hits) { return hits->t.hi; }

/// t of the lanes of `open`, from its range; of the others as it is.
SELDOM_FN realw cylinders_decided_w(PRIVATE const real3w* o, PRIVATE const real3w* d, const Cylinders_w* cylinder,
                                    uint open, uint is_near, uint departed, PRIVATE const realw* least,
                                    PRIVATE const realw* most, realw t) {
  for (; open != 0u; open &= open - 1u) {
    int i = first_bit(open);
    ExactCase one;
    one.o = get3_w(o, i);
    one.d = get3_w(d, i);
    one.a = get3_w(&cylinder->foot, i);
    one.b = one.c = get3_w(&cylinder->axis, i);
    one.r = get_w(&cylinder->r, i);
    int root = (departed >> i & 1u) != 0u ? EXACT_ACROSS : (is_near >> i & 1u) != 0u ? EXACT_NEAR : EXACT_FAR;
    put_w(&t, i, exact_root(EXACT_MANTLE, &one, get_w(least, i), get_w(most, i), root));
  }
  return t;
}

/// t of the lanes that hit, correctly rounded; about t of the others. With A = |d x v|, s = (|f| + r) |v| / A, norms of
/// f and v being sums of absolute values, and h half the chord, t is off by less than 2^-42 (s + |t|) (1 + r |v| / (A
/// h)) where A >= 2^-20 |d| |v|: of u^2, 14 for each dot product and 28 for the discriminant; -2 b / a by twice that
/// for an infinite h.
FN realw cylinder_t_w(real3w o, real3w d, const Cylinders_w* cylinder, const CylinderHits_w* hits, maskw departed) {
  dw_w t = hits->t;
  realw r = cylinder->r, length_v = size1_w(cylinder->axis), across = sqrt_w(hits->a);
  realw s = (size1_w(sub3_w(o, cylinder->foot)) + r) * length_v / across + abs_w(t.hi);
  realw chord = sel_w(departed, splat_w(REAL_MAX), hits->half_chord);
  realw off = splat_w(R(16.0) * DOUBLE_WORD_ROUNDOFF) * fma_w(s, r * length_v / (across * chord), s);
  maskw is_known = lt_w(splat_w(R(0x1p-36)) * length_v * length_v, hits->a) & lt_w(splat_w(R(0x1p-60)), r) &
                   lt_w(splat_w(R(0x1p-60)), s) & lt_w(off, splat_w(R(0x1p-10)) * chord);
  realw nothing = splat_w(exact_nothing());
  realw least = sel_w(is_known, t.hi + (t.lo - off), nothing), most = t.hi + (t.lo + off);
  maskw open = hits->which & ~eq_w(least, most);
  if (!any_w(open)) return t.hi;
  return cylinders_decided_w(&o, &d, cylinder, bits_w(open), bits_w(hits->is_near), bits_w(departed), &least, &most,
                             t.hi);
}
