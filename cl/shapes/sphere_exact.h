// SPDX-License-Identifier: MIT
// Roots of one ray and one sphere in a block, robust tier, one lane, from the exact f = o - c: most by
// sphere_exact_lanes.h. Where the line all but grazes the sphere, or the root is all but at the origin, the
// discriminant is (d.d) r^2 - |f x d|^2 and the smaller root c over the larger one, c = f.f - r^2, all of it in double
// words. Bounds: docs/decisions/0007-robust-tier.md. prim: the sphere's own planes, `stride` apart.

typedef struct {
  real near, far;
  int is_met;
} SphereRoots;

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

/// Whether a ray that has left the sphere may meet it again at t: ahead, and within the slabs that the tree knows,
/// which an origin that is not on the sphere may miss.
FN int sphere_is_left_at(const Ray* ray, GLOBAL const real* prim, int stride, real t) {
  real x = prim[0], y = prim[stride], z = prim[2 * stride], r = prim[3 * stride];
  return R(0.0) < t && t == LANED(within_slabs)(ray, t, x - r, x + r, y - r, y + r, z - r, z + r);
}

FN real3 center_of(GLOBAL const real* prim, int stride) { return vec3(prim[0], prim[stride], prim[2 * stride]); }

/// The first root from t_min on, or where it has been left, the other one; hit: there is one.
ONCE_FN real sphere_root(const Ray* ray, GLOBAL const real* prim, int stride, int is_left, PRIVATE int* hit) {
  LANED(ExactRays) one = exact_ray(ray);
  dw3_w f = LANED(exact_difference)(ray->o, vec3(prim[0], prim[stride], prim[2 * stride]));
  real r = prim[3 * stride];
  if (is_left) {
    real t = LANED(sphere_root_across)(&one, f);
    *hit = sphere_is_left_at(ray, prim, stride, t);
    return t;
  }
  maskw plain, which = ~none_w();
  real t = LANED(sphere_t)(&one, f, r, which, &plain);
  *hit = 1;
  if (plain) return t;
  SphereRoots roots = sphere_roots(ray, f, r);
  *hit = roots.is_met;
  return ray->t_min <= roots.near ? roots.near : roots.far;
}

/// Decides one sphere that may be met. The best so far is exact.
FN void sphere_decide(const Ray* ray, GLOBAL const real* prim, int stride, int id, int kind, int slot, Nearest* best) {
  int hit;
  real t = sphere_root(ray, prim, stride, ray->left >= 0 && id == ray->left, &hit);
  if (hit && ray->t_min <= t) nearest_take(best, t, id, kind, slot);
}

/// t of a sphere that is hit for certain, and has not been left.
FN real sphere_exact_t(const Ray* ray, GLOBAL const real* prim, int stride) {
  int hit;
  return sphere_root(ray, prim, stride, 0, &hit);
}
