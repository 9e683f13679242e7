// SPDX-License-Identifier: MIT
// Roots of a ray and a sphere, robust tier, one lane. Where the line passes well within the sphere and not all but at
// the origin, two steps of Newton's method from the textbook's root, on f + t d with f = o - c exact: what that rounds
// to is small beside t. Else in double words from the exact f = o - c. With k = (f.d) / (d.d) the line's point nearest
// to the centre is l = f - k d, the discriminant (d.d) (r^2 - l.l), and t = (-(f.d) -+ sqrt(...)) / (d.d) rounded once:
// E. Haines, J. Guenther, T. Akenine-Moeller, "Precision Improvements for Ray/Sphere Intersection", Ray Tracing Gems,
// ch. 7, 2019. Where a root is of nearly equal terms or the sphere 2^18 radii off, the discriminant is (d.d) r^2 - |f x
// d|^2 and the smaller root c over the larger one, c = f.f - r^2, at four times the cost. Bounds:
// docs/decisions/0007-robust-tier.md.

typedef struct {
  real near, far;
  real other;  ///< -2 (f.d) / (d.d): the second root of a ray that begins on the sphere.
  int is_met;
} SphereRoots;

/// (x.hi + x.lo) / (d.d).
FN real over_square(const Ray* ray, dw_w x) {
  real q = x.hi * ray->dd_inverse;
  return fma_w(fma_w(-q, ray->dd, x.hi) + fma_w(-q, ray->dd_rest, x.lo), ray->dd_inverse, q);
}

/// x - k d; k = k + k_rest.
FN dw_w less_along(dw_w x, real k, real k_rest, real d) {
  dw_w along = two_prod_w(k, d), s = two_sum_w(x.hi, -along.hi);
  return two_sum_w(s.hi, s.lo + fma_w(-k_rest, d, x.lo - along.lo));
}

/// s - x^2; s.lo grows, nothing is put right.
FN dw_w less_square(dw_w s, dw_w x) {
  dw_w square = two_prod_w(x.hi, x.hi), high = two_sum_w(s.hi, -square.hi);
  high.lo = high.lo + (s.lo - fma_w(x.hi + x.hi, x.lo, square.lo));
  return high;
}

FN void sphere_roots_far(const Ray* ray, dw3_w f, real r, SphereRoots* roots) {
  real dx = ray->d.x, dy = ray->d.y, dz = ray->d.z;
  dw_w a = real_dot_real3_w(dx, dy, dz, dx, dy, dz), b = dot_real3_w(f, dx, dy, dz);
  dw3_w moment = cross_real3_w(f, dx, dy, dz);
  dw_w discriminant = dw_add_w(dw_mul_w(a, two_prod_w(r, r)), dw_negate_w(dw_dot3_w(moment, moment)));
  sum3_w power = sum3_add_w(sum3_begin_w(f.x.hi, f.x.hi, f.y.hi, f.y.hi), f.z.hi, f.z.hi);
  power = sum3_add_w(power, -r, r);
  power = sum3_add_w(power, f.x.hi + f.x.hi, f.x.lo);
  power = sum3_add_w(power, f.y.hi + f.y.hi, f.y.lo);
  power = sum3_add_w(power, f.z.hi + f.z.hi, f.z.lo);
  power.lo = power.lo + fma_w(f.z.lo, f.z.lo, fma_w(f.y.lo, f.y.lo, f.x.lo * f.x.lo));
  LANED(Roots) exact = LANED(quadratic_roots)(a, b, sum3_round_w(power), discriminant);
  roots->is_met = R(0.0) <= discriminant.hi;
  roots->near = exact.near.hi;
  roots->far = exact.far.hi;
  roots->other = -R(2.0) * dw_div_w(b, a).hi;
}

FN SphereRoots sphere_roots(const Ray* ray, dw3_w f, real r) {
  SphereRoots roots;
  real dx = ray->d.x, dy = ray->d.y, dz = ray->d.z;
  dw_w bx = two_prod_w(f.x.hi, dx), by = two_prod_w(f.y.hi, dy), bz = two_prod_w(f.z.hi, dz);
  dw_w bxy = two_sum_w(bx.hi, by.hi), bxyz = two_sum_w(bxy.hi, bz.hi);
  real b_rest = (bxy.lo + bxyz.lo) + (bx.lo + by.lo + bz.lo);
  dw_w b = two_sum_w(bxyz.hi, b_rest + fma_w(f.z.lo, dz, fma_w(f.y.lo, dy, f.x.lo * dx)));

  real k = b.hi * ray->dd_inverse;
  real k_rest = (fma_w(-k, ray->dd, b.hi) + fma_w(-k, ray->dd_rest, b.lo)) * ray->dd_inverse;
  dw_w square = less_square(two_prod_w(r, r), less_along(f.x, k, k_rest, dx));
  square = less_square(square, less_along(f.y, k, k_rest, dy));
  square = less_square(square, less_along(f.z, k, k_rest, dz));
  square = two_sum_w(square.hi, square.lo);
  dw_w chord = dw_scale_w(square, ray->dd);
  chord.lo = fma_w(square.hi, ray->dd_rest, chord.lo);
  dw_w root = dw_sqrt_w(chord), sum = two_sum_w(b.hi, root.hi), difference = two_sum_w(root.hi, -b.hi);
  sum.lo = sum.lo + (b.lo + root.lo);
  difference.lo = difference.lo + (root.lo - b.lo);
  roots.is_met = R(0.0) <= square.hi;
  roots.near = -over_square(ray, sum);
  roots.far = over_square(ray, difference);
  roots.other = -(k + k) - (k_rest + k_rest);

  real least = R(0x1p-18), size = real_abs(f.x.hi) + real_abs(f.y.hi) + real_abs(f.z.hi), least_t = least * real_abs(k);
  int is_near = least * size <= r, is_sound = least_t <= real_abs(roots.near) && least_t <= real_abs(roots.far);
  if (!(is_near && (is_sound || !roots.is_met))) sphere_roots_far(ray, f, r, &roots);
  return roots;
}

/// Whether a ray that has left the sphere may meet it again at t: ahead, and within the slabs that the tree knows,
/// which an origin that is not on the sphere may miss.
FN int sphere_is_left_at(const Ray* ray, GLOBAL const real* prim, int stride, real t) {
  real x = prim[0], y = prim[stride], z = prim[2 * stride], r = prim[3 * stride];
  return R(0.0) < t && t == LANED(within_slabs)(ray, t, x - r, x + r, y - r, y + r, z - r, z + r);
}

/// A root near `t`, to 1 ulp where 4 r^2 <= |t| |q.d|, q.d out: f + t d along d.
FN real sphere_root_near(const Ray* ray, dw3_w f, real r, real t, PRIVATE real* q_d) {
  for (int step = 0; step < 2; ++step) {
    real x = fma_w(t, ray->d.x, f.x.hi) + f.x.lo, y = fma_w(t, ray->d.y, f.y.hi) + f.y.lo;
    real z = fma_w(t, ray->d.z, f.z.hi) + f.z.lo;
    *q_d = fma_w(z, ray->d.z, fma_w(y, ray->d.y, x * ray->d.x));
    real excess = fma_w(z, z, fma_w(y, y, fma_w(x, x, -(r * r))));
    t = fma_w(-R(0.5) * excess, R(1.0) / *q_d, t);
  }
  return t;
}

/// t of the first root from t_min on; 0 where it is to be asked of sphere_roots.
FN int sphere_is_plain(const Ray* ray, dw3_w f, real r, PRIVATE real* t) {
  real k = -fma_w(f.z.hi, ray->d.z, fma_w(f.y.hi, ray->d.y, f.x.hi * ray->d.x)) * ray->dd_inverse;
  real x = fma_w(k, ray->d.x, f.x.hi), y = fma_w(k, ray->d.y, f.y.hi), z = fma_w(k, ray->d.z, f.z.hi);
  real square = r * r, inside = square - fma_w(z, z, fma_w(y, y, x * x));
  // l is off by less than 8 u |f|, so `inside` by 16 u |f| r and 4 u of the square: with 2^6 times that the line passes
  // within, and half the chord is known to 2^-7.
  real size = real_abs(f.x.hi) + real_abs(f.y.hi) + real_abs(f.z.hi);
  if (!(R(0x1p-14) * r * (size + r) <= inside)) return 0;
  real half_chord = real_sqrt(inside * ray->dd_inverse), q_d;
  *t = sphere_root_near(ray, f, r, k - half_chord, &q_d);
  if (!(R(4.0) * square <= real_abs(*t * q_d))) return 0;
  if (ray->t_min <= *t) return 1;
  *t = sphere_root_near(ray, f, r, k + half_chord, &q_d);
  return R(4.0) * square <= real_abs(*t * q_d);
}
