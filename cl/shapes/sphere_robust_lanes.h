// SPDX-License-Identifier: MIT
// Ray against LANES spheres, robust tier: with f = o - c as a double word, the discriminant (d.d) r^2 - |f x d|^2, f.d
// and c = f.f - r^2 keep their sign and size however small r / |f| is or however close o is to the surface; t is
// rounded once. The cross product instead of b^2 - a c: E. Haines, J. Guenther, T. Akenine-Moeller, Ray Tracing Gems,
// ch. 7, 2019. Bounds: docs/decisions/0007-robust-tier.md.
// The sphere just left is met again only at its other root, -2 (f.d) / (d.d): the known root is exactly 0.

FN void LANED(sphere_block)(const Ray* ray, GLOBAL const real* block, GLOBAL const int* ids, int slot, Nearest* best) {
  dw3_w f = two_difference3_w(splat_w(ray->o.x), splat_w(ray->o.y), splat_w(ray->o.z), load_w(block),
                              load_w(block + LANES), load_w(block + 2 * LANES));
  realw r = load_w(block + 3 * LANES);
  maskw candidate = LANED(within_reach)(ray, best, f.x.hi, f.y.hi, f.z.hi, r);
  maskw left = candidate & ~candidate;
  if (ray->left >= 0) left = LANED(is_left)(ids, ray);
  if (!any_w(candidate | left)) return;

  realw dx = splat_w(ray->d.x), dy = splat_w(ray->d.y), dz = splat_w(ray->d.z), zero = splat_w(R(0.0));
  dw_w a = real_dot_real3_w(dx, dy, dz, dx, dy, dz), b = dot_real3_w(f, dx, dy, dz);
  dw3_w moment = cross_real3_w(f, dx, dy, dz);
  dw_w discriminant = dw_add_w(dw_mul_w(a, two_prod_w(r, r)), dw_negate_w(dw_dot3_w(moment, moment)));
  maskw hit = le_w(zero, discriminant.hi);

  sum3_w power = sum3_add_w(sum3_begin_w(f.x.hi, f.x.hi, f.y.hi, f.y.hi), f.z.hi, f.z.hi);
  power = sum3_add_w(power, -r, r);
  power = sum3_add_w(power, f.x.hi + f.x.hi, f.x.lo);
  power = sum3_add_w(power, f.y.hi + f.y.hi, f.y.lo);
  power = sum3_add_w(power, f.z.hi + f.z.hi, f.z.lo);
  power.lo = power.lo + fma_w(f.z.lo, f.z.lo, fma_w(f.y.lo, f.y.lo, f.x.lo * f.x.lo));

  LANED(Roots) roots = LANED(quadratic_roots)(a, b, sum3_round_w(power), discriminant);
  realw t = sel_w(le_w(splat_w(ray->t_min), roots.near.hi), roots.near.hi, roots.far.hi);
  realw other = splat_w(-R(2.0)) * dw_div_w(b, a).hi;
  t = sel_w(left, other, t);
  hit = (hit & ~left) | (left & lt_w(zero, other));
  if (ray->is_outward) hit = hit & ~left;
  LANED(take_nearest)(hit & LANED(in_range)(t, ray, best), t, ids, -1, SHAPE_sphere, slot, best);
}
