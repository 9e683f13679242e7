// SPDX-License-Identifier: MIT
// A ray, and what intersection bodies of every width want prepared of it. Frame: the one the scene was uploaded in.
#ifndef STRAHL_CORE_RAY_H
#define STRAHL_CORE_RAY_H

#include "math/vec3.h"
#include "portable.h"
#if TIER_FAST
#include "core/epsilon_fast.h"
#endif

/// The direction is scaled by an exact power of two so that max |d_i| lies in [1, 2): tiny and huge directions then
/// neither underflow nor overflow. t of this ray = t of the given ray times t_scale.
typedef struct {
  real3 o, d;
  real t_min, t_max;   ///< Both inclusive; in units of d.
  real t_from_scaled;  ///< t in units of the direction as given = t * t_from_scaled.
  int left;            ///< Scene-wide id of the primitive just left, -1: none. It is not hit again where it was left.
  int is_outward;      ///< 1: that primitive is convex and the ray goes away from it, so it is not hit again at all.

  real3 inv;  ///< 1 / d, infinite where d is 0.
#if TIER_COMPENSATED
  real dd, dd_rest, dd_inverse;  ///< d.d as a double word, and 1 / (d.d).
#endif
  real3 slack;                     ///< By how much slabs are widened, in t, per axis (ray_widen).
  int near_x, near_y, near_z;      ///< Plane of a box (0 lo_x, 1 hi_x, 2 lo_y, ...) that the ray meets first, per axis.
  int kx, ky, kz;                  ///< Axes of the shear: kz the largest of |d|, the others after it in turn. Not
                                   ///< exchanged where d looks backwards: hits from both sides count, and a mirrored
                                   ///< scene has the same bits.
  real shear_x, shear_y, shear_z;  ///< Woop, Benthin, Wald, "Watertight Ray/Triangle Intersection", JCGT 2(1), 2013.
} Ray;

FN real component(real3 v, int axis) { return axis == 0 ? v.x : (axis == 1 ? v.y : v.z); }

/// Orders |x| as an integer, with NaN above infinity.
FN bitsr magnitude_bits(real x) { return real_to_bits(x) << 1; }
FN bitsr larger_bits(bitsr a, bitsr b) { return a < b ? b : a; }

/// A ray with a NaN anywhere, with an infinite origin or direction, or with direction 0, hits nothing.
FN Ray ray_make(real3 o, real3 d, real t_min, real t_max, int left) {
  Ray ray;
  real3 magnitude = abs3(d);
  PowerOfTwo scale = power_of_two_to_one(max3(magnitude));
  ray.o = o;
  ray.d = scale3(scale.up, d);
  // A t that is not finite, here or in units of d as given, is out of reach: no hit has one.
  real reach = scale.down < R(1.0) ? REAL_MAX * scale.down : REAL_MAX;
  ray.t_min = t_min * scale.down;
  ray.t_max = t_max * scale.down;
  if (ray.t_min < -reach) ray.t_min = -reach;
  if (ray.t_max > reach) ray.t_max = reach;
  ray.t_from_scaled = scale.up;
#if TIER_FAST
  if (left >= 0 && ray.t_min < t_min_past_epsilon(ray.d)) ray.t_min = t_min_past_epsilon(ray.d);
  left = -1;
#endif
  ray.left = left;
  ray.is_outward = 0;
  bitsr largest = larger_bits(magnitude_bits(o.x), larger_bits(magnitude_bits(o.y), magnitude_bits(o.z)));
  largest =
      larger_bits(largest, larger_bits(magnitude_bits(d.x), larger_bits(magnitude_bits(d.y), magnitude_bits(d.z))));
  int is_finite = largest < (bitsr)REAL_EXPONENT_MASK << (REAL_EXPONENT_SHIFT + 1);
  int usable = is_finite & (max3(magnitude) > R(0.0)) & !real_is_nan(t_min) & !real_is_nan(t_max) & (t_min <= t_max);
  if (!usable) {
    ray.t_min = R(1.0);
    ray.t_max = -R(1.0);
  }

  ray.inv = vec3(R(1.0) / ray.d.x, R(1.0) / ray.d.y, R(1.0) / ray.d.z);
#if TIER_COMPENSATED
  real xx = ray.d.x * ray.d.x, yy = ray.d.y * ray.d.y, zz = ray.d.z * ray.d.z, xy = xx + yy;
  real products_rest =
      real_fma(ray.d.x, ray.d.x, -xx) + real_fma(ray.d.y, ray.d.y, -yy) + real_fma(ray.d.z, ray.d.z, -zz);
  ray.dd = xy + zz;
  ray.dd_rest = products_rest + (difference_rest(xx, -yy, xy) + difference_rest(xy, -zz, ray.dd));
  ray.dd_inverse = R(1.0) / ray.dd;
#endif
  ray.slack = vec3(REAL_MAX, REAL_MAX, REAL_MAX);
  ray.near_x = ray.inv.x < R(0.0) ? 1 : 0;
  ray.near_y = ray.inv.y < R(0.0) ? 3 : 2;
  ray.near_z = ray.inv.z < R(0.0) ? 5 : 4;

  int kz = magnitude.x > magnitude.y ? (magnitude.x > magnitude.z ? 0 : 2) : (magnitude.y > magnitude.z ? 1 : 2);
  int kx = kz == 2 ? 0 : kz + 1;
  int ky = kx == 2 ? 0 : kx + 1;
  ray.kx = kx;
  ray.ky = ky;
  ray.kz = kz;
  ray.shear_z = component(ray.inv, kz);
  ray.shear_x = component(ray.d, kx) * ray.shear_z;
  ray.shear_y = component(ray.d, ky) * ray.shear_z;
  return ray;
}

/// From here on boxes within `reach` (centre x y z, half the size x y z) are met for certain where what they hold is:
/// sideways by 16 u of the farthest they lie from the origin, which is what tests of primitives and of slabs may err by
/// together (docs/decisions/0008-tree.md). Along an axis that the ray does not move on, signs are exact.
FN void ray_widen(Ray* ray, GLOBAL const real* reach) {
  real3 farthest = add3(abs3(sub3(load3(reach), ray->o)), load3(reach + 3));
  real aside = R(16.0) * real_roundoff() * max3(farthest);
  // Where a surface was left, the origin may stand off it by its own rounding, as one of float where rays come in
  // float, and what was left is met again at its other root all the same.
  if (ray->left >= 0) {
    real off = R(0x1p-20) * max3(abs3(ray->o));
    aside = aside < off ? off : aside;
  }
  ray->slack.x = ray->d.x == R(0.0) ? R(0.0) : aside * real_abs(ray->inv.x);
  ray->slack.y = ray->d.y == R(0.0) ? R(0.0) : aside * real_abs(ray->inv.y);
  ray->slack.z = ray->d.z == R(0.0) ? R(0.0) : aside * real_abs(ray->inv.z);
}

/// t of a hit in units of the direction as given, held within the range asked for: scaling may round denormal numbers.
FN real ray_given_t(const Ray* ray, real t, real t_min, real t_max) {
  t *= ray->t_from_scaled;
  if (t < t_min) t = t_min;
  if (t_max < t) t = t_max;
  return t;
}

#endif
