// SPDX-License-Identifier: MIT
// Roots of a ray and a sphere, robust tier, a ray and a sphere a lane, correctly rounded: from the line's point nearest
// to the centre, in wide arithmetic, and where that leaves a doubt exactly (shapes/exact/exact_t.h). After E. Haines,
// J. Guenther, T. Akenine-Moeller, "Precision Improvements for Ray/Sphere Intersection", Ray Tracing Gems, ch. 7, 2019.
// One width; no guard.

/// What is certain of a line and a sphere.
typedef struct {
  maskw meets, misses;
  realw near_least, near_most, far_least, far_most;  ///< Ranges of both roots where it meets; NaN elsewhere.
  wide_w near, far, dd;                              ///< The roots, and d.d.
  realw off;                                         ///< How far the roots may be off.
} SphereRoots_w;

/// With f = o - c, k = -(f.d) / (d.d), p = f + k d and M = r^2 - p.p the roots are k -+ sqrt(M / (d.d)). w: the
/// roundoff; norms are sums of absolute values, s = |f| + r, q = |p| + r, 1 <= d.d. k is off by 14 w s at most, which
/// changes p.p by its square alone, less than 19 w q s where 128 w s <= q; rounding changes M by 16 w q s. So beyond
/// 128 w q s the sign of M is certain, and half the chord, h, is off by 19 w q s / ((d.d) h); t by 20 w s (1 + q /
/// ((d.d) h)). Double words: what underflow does is less than w times 2^-90.
FN SphereRoots_w sphere_roots_w(real3w o, real3w d, real3w c, realw r) {
  wide3_w f = wide_difference3_w(o, c), p;
  wide_w a = wide_add_w(wide_add_w(wide_product_w(d.x, d.x), wide_product_w(d.y, d.y)), wide_product_w(d.z, d.z));
  wide_w inverse = wide_divide_w(wide_of_w(splat_w(R(1.0))), a);
  wide_w back = wide_multiply_w(wide_dot_w(f, d), inverse);
  p.x = wide_subtract_w(f.x, wide_scale_w(back, d.x));
  p.y = wide_subtract_w(f.y, wide_scale_w(back, d.y));
  p.z = wide_subtract_w(f.z, wide_scale_w(back, d.z));
  wide_w inside = wide_subtract_w(wide_product_w(r, r), wide_dot3_w(p, p));
  wide_w chord = wide_root_w(wide_multiply_w(inside, inverse));

  realw q = size1_w(vec3_w(narrow_w(p.x), narrow_w(p.y), narrow_w(p.z))) + r, s = size1_w(sub3_w(o, c)) + r;
  realw m = narrow_w(inside), lost = splat_w(R(32.0) * WIDE_ROUNDOFF), unsure = splat_w(R(4.0)) * lost * q * s;
  realw off = lost * fma_w(s, q * narrow_w(inverse) / narrow_w(chord), s);
  maskw is_in_scale = lt_w(splat_w(R(0x1p-90)), q * s);
  SphereRoots_w roots;
  roots.meets = is_in_scale & lt_w(unsure, m);
  roots.misses = is_in_scale & lt_w(m, -unsure);
  roots.near = wide_negate_w(wide_add_w(back, chord));
  roots.far = wide_subtract_w(chord, back);
  roots.dd = a;
  roots.off = off;
  wide_range_w(roots.near, off, roots.meets, &roots.near_least, &roots.near_most);
  wide_range_w(roots.far, off, roots.meets, &roots.far_least, &roots.far_most);
  return roots;
}

/// |o - c|^2 - r^2, within 2^-47 of itself and *off.
FN dw_w sphere_power_w(real3w o, real3w c, realw r, PRIVATE realw* off) {
  dw3_w f = two_difference3_w(o.x, o.y, o.z, c.x, c.y, c.z);
  sum3_w s = sum3_begin_w(f.x.hi, f.x.hi, -r, r);
  s = sum3_add_w(sum3_add_w(s, f.y.hi, f.y.hi), f.z.hi, f.z.hi);
  s = sum3_add_w(sum3_add_w(sum3_add_w(s, f.x.hi + f.x.hi, f.x.lo), f.y.hi + f.y.hi, f.y.lo), f.z.hi + f.z.hi, f.z.lo);
  s = sum3_add_w(sum3_add_w(sum3_add_w(s, f.x.lo, f.x.lo), f.y.lo, f.y.lo), f.z.lo, f.z.lo);
  realw size = size1_w(vec3_w(f.x.hi, f.y.hi, f.z.hi));
  *off = splat_w(R(0x1p-58)) * fma_w(size, size, r * r);
  return sum3_round_w(s);
}

/// Narrows the range of the root nearer to the origin, which is a small difference where the sphere is large and near:
/// a ground, a planet. The product of the roots is the power of the origin, P, over d.d, so that root is P over d.d and
/// the other, which is known to off / |other|. Ten products as if in three-fold precision have P within (40 u)^3 / 8 <
/// 2^-59 of the sum of their absolute values, and what underflow does to them is less than 2^-140.
SELDOM_FN void sphere_roots_narrow_w(PRIVATE const ExactRays_w* rays, PRIVATE const real3w* c, PRIVATE const realw* r,
                                     PRIVATE SphereRoots_w* roots) {
  realw power_off, two = splat_w(R(2.0));
  dw_w power = sphere_power_w(rays->o, *c, *r, &power_off);
  realw near = narrow_w(roots->near), far = narrow_w(roots->far);
  maskw is_near = lt_w(abs_w(near), abs_w(far));
  wide_w others = wide_sel_w(is_near, roots->far, roots->near), whole = wide_multiply_w(roots->dd, others);
  wide_w root = wide_divide_w(wide_of_dw_w(power), whole);
  realw size = abs_w(narrow_w(others)), share = roots->off / size;
  realw off = fma_w(abs_w(narrow_w(root)), fma_w(two, share, splat_w(R(32.0) * WIDE_ROUNDOFF + R(0x1p-45))),
                    two * power_off / abs_w(narrow_w(whole)));
  maskw is_known = roots->meets & lt_w(share, splat_w(R(0.25))) & lt_w(splat_w(R(0x1p-120)), power_off) &
                   lt_w(splat_w(R(0x1p-60)), size) & lt_w(size, splat_w(R(0x1p+60)));
  realw least = wide_least_w(root, off), most = wide_most_w(root, off);
  maskw narrows_near = is_known & is_near, narrows_far = is_known & ~is_near;
  roots->near_least = sel_w(narrows_near, max_w(least, roots->near_least), roots->near_least);
  roots->near_most = sel_w(narrows_near, min_w(most, roots->near_most), roots->near_most);
  roots->far_least = sel_w(narrows_far, max_w(least, roots->far_least), roots->far_least);
  roots->far_most = sel_w(narrows_far, min_w(most, roots->far_most), roots->far_most);
}

/// exact_sphere_t of the lanes of `open`, into t.
SELDOM_FN void sphere_decided_w(PRIVATE const ExactRays_w* rays, PRIVATE const real3w* c, PRIVATE const realw* r,
                                PRIVATE const SphereRoots_w* roots, uint open, PRIVATE realw* t) {
  for (; open != 0u; open &= open - 1u) {
    int i = first_bit(open);
    ExactCase one;
    real least[2], most[2];
    one.o = get3_w(&rays->o, i);
    one.d = get3_w(&rays->d, i);
    one.a = one.b = one.c = get3_w(c, i);
    one.r = get_w(r, i);
    least[0] = get_w(&roots->near_least, i);
    most[0] = get_w(&roots->near_most, i);
    least[1] = get_w(&roots->far_least, i);
    most[1] = get_w(&roots->far_most, i);
    put_w(t, i, exact_sphere_t(&one, get_w(&rays->t_min, i), least, most));
  }
}

/// Of the lanes of `which`, those whose roots do not tell the first from t_min on. t: of the others.
FN maskw sphere_open_w(const ExactRays_w* rays, PRIVATE const SphereRoots_w* roots, maskw which, PRIVATE realw* t) {
  maskw is_near = le_w(rays->t_min, roots->near_least);
  *t = sel_w(is_near, roots->near_least, roots->far_least);
  maskw sure = eq_w(roots->near_least, roots->near_most) & (is_near | eq_w(roots->far_least, roots->far_most));
  return which & ~(sure | roots->misses);
}

/// Of the lanes of `which`, those whose first root from t_min on wide arithmetic does not tell. t: of the others.
FN maskw sphere_undecided_w(const ExactRays_w* rays, real3w c, realw r, maskw which, PRIVATE SphereRoots_w* roots,
                            PRIVATE realw* t) {
  *roots = sphere_roots_w(rays->o, rays->d, c, r);
  maskw open = sphere_open_w(rays, roots, which, t);
  if (!any_w(open)) return open;
  sphere_roots_narrow_w(rays, &c, &r, roots);
  return sphere_open_w(rays, roots, which, t);
}

/// The first root from t_min on of the sphere about c, the last one where there is none. which: lanes to compute; met:
/// of these, lanes that have a root.
ONCE_FN realw sphere_root_w(const ExactRays_w* rays, real3w c, realw r, maskw which, PRIVATE maskw* met) {
  SphereRoots_w roots;
  realw t;
  maskw open = sphere_undecided_w(rays, c, r, which, &roots, &t);
  if (any_w(open)) sphere_decided_w(rays, &c, &r, &roots, bits_w(open), &t);
  *met = ~nan_w(t);
  return t;
}

/// -2 (f.d) / (d.d), correctly rounded: the second root of a ray that begins on the sphere. which: lanes to compute.
FN realw sphere_root_across_w(const ExactRays_w* ray, real3w c, maskw which) {
  realw most = splat_w(REAL_MAX);
  return splat_w(R(2.0)) * plane_t_w(ray->o, ray->d, c, ray->d, -most, most, which);
}

/// The approximate first root from t_min on, for a sphere that the line certainly passes through, and in *about a bound
/// on its error. k, off: as in sphere_in_reach. inside: r^2 minus the squared distance of line and centre, known to
/// 1/32. Returns the lanes where that root is certainly after t_min.
FN maskw sphere_approximately_w(realw t_min, realw dd_inverse, realw k, realw off, realw inside, PRIVATE realw* t,
                                PRIVATE realw* about) {
  realw half_chord = sqrt_w(inside * dd_inverse);
  *about = fma_w(splat_w(R(0x1p-6)), half_chord, off + off);
  *t = sel_w(lt_w(k - half_chord + *about, t_min), k + half_chord, k - half_chord);
  return le_w(t_min, *t - *about);
}
