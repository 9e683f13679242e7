// SPDX-License-Identifier: MIT
// Roots of a ray and a sphere, robust tier, a ray and a sphere a lane, from the exact f = o - c. Most roots are
// computed relative to the line's point nearest to the centre, if necessary with one step of Newton's method in double
// words: E. Haines, J. Guenther, T. Akenine-Moeller, "Precision Improvements for Ray/Sphere Intersection", Ray Tracing
// Gems, ch. 7, 2019. Where the line nearly grazes the sphere, or the root is nearly at the origin, the discriminant is
// (d.d) r^2 - |f x d|^2 and the smaller root c over the larger one, c = f.f - r^2, all of it in double words. Bounds:
// docs/decisions/0007-robust-tier.md. One width; no guard.

/// x + t d.
FN dw_w plus_along_w(dw_w x, realw t, realw d) {
  dw_w along = two_prod_w(t, d), s = two_sum_w(x.hi, along.hi);
  s.lo = s.lo + (along.lo + x.lo);
  return s;
}

FN dw_w square_of_w(dw_w x) {
  dw_w square = two_prod_w(x.hi, x.hi);
  square.lo = fma_w(x.hi + x.hi, x.lo, square.lo);
  return square;
}

/// One step of Newton's method from a root t that is known to some u of the distance and of r, in double words. Not
/// plain where the line nearly grazes the sphere, or the root is nearly at the origin or 2^19 radii away: there one
/// step does not reach an error of half an ulp and 2^-3.
FN realw sphere_refined_w(const ExactRays_w* ray, dw3_w f, realw r, realw t, PRIVATE maskw* plain) {
  real3w d = ray->d;
  dw_w x = plus_along_w(f.x, t, d.x), y = plus_along_w(f.y, t, d.y), z = plus_along_w(f.z, t, d.z);
  realw q_d = fma_w(z.hi, d.z, fma_w(y.hi, d.y, x.hi * d.x)), inverse = splat_w(R(1.0)) / q_d;
  dw_w xx = square_of_w(x), yy = square_of_w(y), zz = square_of_w(z), rr = two_prod_w(r, r);
  dw_w one = two_sum_w(xx.hi, -rr.hi), other = two_sum_w(yy.hi, zz.hi), sum = two_sum_w(one.hi, other.hi);
  realw rest = (one.lo + other.lo) + ((xx.lo + yy.lo) + (zz.lo - rr.lo)), far_off = t * t * ray->dd;
  *plain = le_w(splat_w(R(0x1p-6)) * rr.hi * ray->dd, q_d * q_d) & le_w(splat_w(R(0x1p-18)) * rr.hi, far_off) &
           le_w(far_off, splat_w(R(0x1p+38)) * rr.hi);
  return fma_w(splat_w(-R(0.5)) * (sum.hi + (sum.lo + rest)), inverse, t);
}

/// t of the first root from t_min on. k: about -(f.d) / (d.d). At p = f + k d, no larger than the sphere and known to
/// 2 u of itself since an fma rounds what is left of k d and f, the equation's terms are small beside t: t = k - e /
/// (d.d) -+ sqrt((r^2 - p.p + e^2 / (d.d)) / (d.d)) with e = p.d, all but 0. Where 16 r^2 <= |t| (d.d) times the root
/// it is right to 1 ulp: of that 1/8 comes from r^2 - p.p, which is off by 8 u r^2, 3/16 from e and the root. Else it
/// is refined. which: lanes to compute; plain: lanes with a result.
FN realw sphere_t_w(const ExactRays_w* ray, dw3_w f, realw r, maskw which, PRIVATE maskw* plain) {
  real3w d = ray->d;
  realw k = -fma_w(f.z.hi, d.z, fma_w(f.y.hi, d.y, f.x.hi * d.x)) * ray->dd_inverse;
  realw x = fma_w(k, d.x, f.x.hi) + f.x.lo, y = fma_w(k, d.y, f.y.hi) + f.y.lo, z = fma_w(k, d.z, f.z.hi) + f.z.lo;
  realw pp = fma_w(z, z, fma_w(y, y, x * x)), rr = r * r, e = fma_w(z, d.z, fma_w(y, d.y, x * d.x));
  realw inside = fma_w(e * e, ray->dd_inverse, rr - pp);
  *plain = le_w(splat_w(R(0x1p-6)) * rr, inside);
  realw root = sqrt_w(inside * ray->dd_inverse), middle = e * ray->dd_inverse, slope = root * ray->dd;
  realw near = k - (middle + root), far = k - (middle - root), least = splat_w(R(16.0)) * rr;
  realw t = sel_w(le_w(ray->t_min, near), near, far);
  maskw sure =
      le_w(least, abs_w(near) * slope) & le_w(least, abs_w(t) * slope) & le_w(splat_w(R(0x1p-20)) * abs_w(k), r);
  if (!any_w(which & *plain & ~sure)) return t;
  maskw fine, is_far = none_w();
  realw from = near, refined;
  for (;;) {  // The near root; where it lies before t_min, the far one. The program holds the arithmetic once.
    refined = sphere_refined_w(ray, f, r, from, &fine);
    maskw again = fine & lt_w(refined, ray->t_min) & ~is_far;
    if (!any_w(which & again)) break;
    is_far = is_far | again;
    from = sel_w(again, far, from);
  }
  *plain = *plain & (sure | fine);
  return sel_w(sure, t, refined);
}

/// The same for any sphere. met: lanes whose line meets it.
FN realw sphere_t_always_w(const ExactRays_w* ray, dw3_w f, realw r, PRIVATE maskw* met) {
  realw dx = ray->d.x, dy = ray->d.y, dz = ray->d.z;
  dw_w a = quick_two_sum_w(ray->dd, ray->dd_rest), b = dot_real3_w(f, dx, dy, dz);
  dw3_w moment = cross_real3_w(f, dx, dy, dz);
  dw_w discriminant = dw_add_w(dw_mul_w(a, two_prod_w(r, r)), dw_negate_w(dw_dot3_w(moment, moment)));
  sum3_w power = sum3_add_w(sum3_begin_w(f.x.hi, f.x.hi, f.y.hi, f.y.hi), f.z.hi, f.z.hi);
  power = sum3_add_w(power, -r, r);
  power = sum3_add_w(power, f.x.hi + f.x.hi, f.x.lo);
  power = sum3_add_w(power, f.y.hi + f.y.hi, f.y.lo);
  power = sum3_add_w(power, f.z.hi + f.z.hi, f.z.lo);
  power.lo = power.lo + fma_w(f.z.lo, f.z.lo, fma_w(f.y.lo, f.y.lo, f.x.lo * f.x.lo));
  Roots_w roots = quadratic_roots_w(a, b, sum3_round_w(power), discriminant);
  *met = le_w(splat_w(R(0.0)), discriminant.hi);
  return sel_w(le_w(ray->t_min, roots.near.hi), roots.near.hi, roots.far.hi);
}

/// The first root from t_min on of the sphere about x, y, z. which: lanes to compute; met: lanes that have a root.
ONCE_FN realw sphere_root_w(const ExactRays_w* ray, realw x, realw y, realw z, realw r, maskw which,
                            PRIVATE maskw* met) {
  dw3_w f = two_difference3_w(ray->o.x, ray->o.y, ray->o.z, x, y, z);
  maskw plain;
  realw t = sphere_t_w(ray, f, r, which, &plain);
  *met = plain;
  if (!any_w(which & ~plain)) return t;
  realw always = sphere_t_always_w(ray, f, r, met);
  *met = plain | *met;
  return sel_w(plain, t, always);
}

/// -2 (f.d) / (d.d): the second root of a ray that begins on the sphere.
FN realw sphere_root_across_w(const ExactRays_w* ray, dw3_w f) {
  dw_w b = dot_real3_w(f, ray->d.x, ray->d.y, ray->d.z);
  realw q = b.hi * ray->dd_inverse;
  realw rest = fma_w(-q, ray->dd, b.hi) + fma_w(-q, ray->dd_rest, b.lo);
  return splat_w(-R(2.0)) * fma_w(rest, ray->dd_inverse, q);
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
