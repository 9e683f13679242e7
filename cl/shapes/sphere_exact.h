// SPDX-License-Identifier: MIT
// Roots of a ray and a sphere, robust tier, one lane, from the exact f = o - c. Most are found about the line's point
// nearest to the centre, if need be with one step of Newton's method in double words: E. Haines, J. Guenther,
// T. Akenine-Moeller, "Precision Improvements for Ray/Sphere Intersection", Ray Tracing Gems, ch. 7, 2019. Where the
// line all but grazes the sphere, or the root is all but at the origin, the discriminant is (d.d) r^2 - |f x d|^2 and
// the smaller root c over the larger one, c = f.f - r^2, all of it in double words. Bounds:
// docs/decisions/0007-robust-tier.md.

typedef struct {
  real near, far;
  int is_met;
} SphereRoots;

/// (x.hi + x.lo) / (d.d).
FN real over_square(const Ray* ray, dw_w x) {
  real q = x.hi * ray->dd_inverse;
  return fma_w(fma_w(-q, ray->dd, x.hi) + fma_w(-q, ray->dd_rest, x.lo), ray->dd_inverse, q);
}

FN SphereRoots sphere_roots(const Ray* ray, dw3_w f, real r) {
  real dx = ray->d.x, dy = ray->d.y, dz = ray->d.z;
  dw_w a = quick_two_sum_w(ray->dd, ray->dd_rest), b = dot_real3_w(f, dx, dy, dz);
  dw3_w moment = cross_real3_w(f, dx, dy, dz);
  dw_w discriminant = dw_add_w(dw_mul_w(a, two_prod_w(r, r)), dw_negate_w(dw_dot3_w(moment, moment)));
  sum3_w power = sum3_add_w(sum3_begin_w(f.x.hi, f.x.hi, f.y.hi, f.y.hi), f.z.hi, f.z.hi);
  power = sum3_add_w(power, -r, r);
  power = sum3_add_w(power, f.x.hi + f.x.hi, f.x.lo);
  power = sum3_add_w(power, f.y.hi + f.y.hi, f.y.lo);
  power = sum3_add_w(power, f.z.hi + f.z.hi, f.z.lo);
  power.lo = power.lo + fma_w(f.z.lo, f.z.lo, fma_w(f.y.lo, f.y.lo, f.x.lo * f.x.lo));
  LANED(Roots) exact = LANED(quadratic_roots)(a, b, sum3_round_w(power), discriminant);
  SphereRoots roots;
  roots.is_met = R(0.0) <= discriminant.hi;
  roots.near = exact.near.hi;
  roots.far = exact.far.hi;
  return roots;
}

/// -2 (f.d) / (d.d): the second root of a ray that begins on the sphere.
FN real sphere_root_across(const Ray* ray, dw3_w f) {
  dw_w b = dot_real3_w(f, ray->d.x, ray->d.y, ray->d.z);
  return -R(2.0) * over_square(ray, b);
}

/// Whether a ray that has left the sphere may meet it again at t: ahead, and within the slabs that the tree knows,
/// which an origin that is not on the sphere may miss.
FN int sphere_is_left_at(const Ray* ray, GLOBAL const real* prim, int stride, real t) {
  real x = prim[0], y = prim[stride], z = prim[2 * stride], r = prim[3 * stride];
  return R(0.0) < t && t == LANED(within_slabs)(ray, t, x - r, x + r, y - r, y + r, z - r, z + r);
}

/// x + t d.
FN dw_w plus_along(dw_w x, real t, real d) {
  dw_w along = two_prod_w(t, d), s = two_sum_w(x.hi, along.hi);
  s.lo = s.lo + (along.lo + x.lo);
  return s;
}

FN dw_w square_of(dw_w x) {
  dw_w square = two_prod_w(x.hi, x.hi);
  square.lo = fma_w(x.hi + x.hi, x.lo, square.lo);
  return square;
}

/// One step of Newton's method from a root that is known to some u of the distance and of r, in double words. 0 where
/// the line all but grazes the sphere, or the root is all but at the origin or 2^19 radii off: there one step does not
/// make it right to half an ulp and 2^-3.
FN int sphere_root_near(const Ray* ray, dw3_w f, real r, PRIVATE real* root) {
  real t = *root;
  dw_w x = plus_along(f.x, t, ray->d.x), y = plus_along(f.y, t, ray->d.y), z = plus_along(f.z, t, ray->d.z);
  real q_d = fma_w(z.hi, ray->d.z, fma_w(y.hi, ray->d.y, x.hi * ray->d.x)), inverse = R(1.0) / q_d;
  dw_w xx = square_of(x), yy = square_of(y), zz = square_of(z), rr = two_prod_w(r, r);
  dw_w one = two_sum_w(xx.hi, -rr.hi), other = two_sum_w(yy.hi, zz.hi), sum = two_sum_w(one.hi, other.hi);
  real rest = (one.lo + other.lo) + ((xx.lo + yy.lo) + (zz.lo - rr.lo));
  *root = fma_w(-R(0.5) * (sum.hi + (sum.lo + rest)), inverse, t);
  real far_off = t * t * ray->dd;
  return (R(0x1p-6) * rr.hi * ray->dd <= q_d * q_d) & (R(0x1p-18) * rr.hi <= far_off) & (far_off <= R(0x1p+38) * rr.hi);
}

/// t of the first root from t_min on; 0 where it is to be asked of sphere_roots. k: about -(f.d) / (d.d). At p = f + k
/// d, no larger than the sphere and known to 2 u of itself since an fma rounds what is left of k d and f, the
/// equation's terms are small beside t: t = k - e / (d.d) -+ sqrt((r^2 - p.p + e^2 / (d.d)) / (d.d)) with e = p.d, all
/// but 0. Where 16 r^2 <= |t| (d.d) times the root it is right to 1 ulp: of that 1/8 comes from r^2 - p.p, which is off
/// by 8 u r^2, 3/16 from e and the root. Else it is refined.
FN int sphere_is_plain(const Ray* ray, dw3_w f, real r, real k, PRIVATE real* t) {
  real x = fma_w(k, ray->d.x, f.x.hi) + f.x.lo, y = fma_w(k, ray->d.y, f.y.hi) + f.y.lo;
  real z = fma_w(k, ray->d.z, f.z.hi) + f.z.lo, pp = fma_w(z, z, fma_w(y, y, x * x)), rr = r * r;
  real e = fma_w(z, ray->d.z, fma_w(y, ray->d.y, x * ray->d.x)), inside = fma_w(e * e, ray->dd_inverse, rr - pp);
  if (!(R(0x1p-6) * rr <= inside)) return 0;
  real root = real_sqrt(inside * ray->dd_inverse), middle = e * ray->dd_inverse, slope = root * ray->dd;
  real near = k - (middle + root);
  int is_near = ray->t_min <= near;
  *t = is_near ? near : k - (middle - root);
  int is_sure = R(16.0) * rr <= real_abs(near) * slope && R(16.0) * rr <= real_abs(*t) * slope;
  if (is_sure && R(0x1p-20) * real_abs(k) <= r) return 1;
  *t = near;
  if (!sphere_root_near(ray, f, r, t)) return 0;
  if (ray->t_min <= *t) return 1;
  *t = k - (middle - root);
  return sphere_root_near(ray, f, r, t);
}

/// Decides one sphere that may be met; k: as of sphere_is_plain.
FN void sphere_candidate(const Ray* ray, GLOBAL const real* prim, int stride, real k, int id, int kind, int slot,
                         Nearest* best) {
  Exact3 f = exact_difference(ray->o, vec3(prim[0], prim[stride], prim[2 * stride]));
  real t, r = prim[3 * stride];
  int hit = 1;
  if (ray->left >= 0 && id == ray->left) {
    t = sphere_root_across(ray, f);
    hit = !ray->is_outward && sphere_is_left_at(ray, prim, stride, t);
  } else if (!sphere_is_plain(ray, f, r, k, &t)) {
    SphereRoots roots = sphere_roots(ray, f, r);
    t = ray->t_min <= roots.near ? roots.near : roots.far;
    hit = roots.is_met;
  }
  if (hit && ray->t_min <= t) nearest_take(best, t, id, kind, slot);
}
