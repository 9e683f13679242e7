// SPDX-License-Identifier: MIT
// The values of rays that intersection bodies need prepared, LANES rays at a time, which is faster than one by one
// (docs/decisions/0008-tree.md). One width; no guard: rays/ray.h includes it with one lane.

/// Rays as given. The direction is of any length; `has_left`: a surface has just been left.
typedef struct {
  realw ox, oy, oz, dx, dy, dz, t_min, t_max;
  maskw has_departed;
} GivenRays_w;

FN realw largest_of_w(realw x, realw y, realw z) { return max_w(abs_w(z), max_w(abs_w(y), abs_w(x))); }

/// to: RAY_PLANES planes of LANES reals. A ray with a NaN anywhere, with an infinite origin or direction, or with
/// direction 0, hits nothing.
FN void prepare_rays_w(const GivenRays_w* given, PRIVATE realw* to) {
  realw zero = splat_w(R(0.0)), one = splat_w(R(1.0)), most = splat_w(REAL_MAX);
  realw largest = largest_of_w(given->dx, given->dy, given->dz);
  maskw is_moving = lt_w(zero, largest);
  realw down = sel_w(is_moving, power_of_two_w(largest), one), up = inverse_power_w(down);
  realw dx = given->dx * up, dy = given->dy * up, dz = given->dz * up;
  // A t that is not finite, here or in units of d as given, is out of reach: no hit has one.
  realw reach = sel_w(lt_w(down, one), most * down, most);
  realw t_min = given->t_min * down, t_max = given->t_max * down;
  t_min = sel_w(lt_w(t_min, -reach), -reach, t_min);
  t_max = sel_w(lt_w(reach, t_max), reach, t_max);
#if TIER_FAST
  realw past = splat_w(FAST_EPSILON) / sqrt_w(fma_w(dz, dz, fma_w(dy, dy, dx * dx)));
  t_min = sel_w(given->has_departed & lt_w(t_min, past), past, t_min);
#endif
  maskw usable = is_moving & finite_w(given->ox) & finite_w(given->oy) & finite_w(given->oz) & finite_w(given->dx) &
                 finite_w(given->dy) & finite_w(given->dz) & ~nan_w(given->t_min) & ~nan_w(given->t_max) &
                 le_w(given->t_min, given->t_max);
  t_min = sel_w(usable, t_min, one);
  t_max = sel_w(usable, t_max, -one);
  to[RAY_PLANE_O] = given->ox;
  to[RAY_PLANE_O + 1] = given->oy;
  to[RAY_PLANE_O + 2] = given->oz;
  to[RAY_PLANE_D] = dx;
  to[RAY_PLANE_D + 1] = dy;
  to[RAY_PLANE_D + 2] = dz;
  to[RAY_PLANE_T_MIN] = t_min;
  to[RAY_PLANE_T_MAX] = t_max;
  to[RAY_PLANE_T_FROM_SCALED] = up;

  realw inv_x = one / dx, inv_y = one / dy, inv_z = one / dz;
  to[RAY_PLANE_INV] = inv_x;
  to[RAY_PLANE_INV + 1] = inv_y;
  to[RAY_PLANE_INV + 2] = inv_z;
#if TIER_COMPENSATED
  realw xx = dx * dx, yy = dy * dy, zz = dz * dz, xy = xx + yy, dd = xy + zz;
  realw rest = fma_w(dx, dx, -xx) + fma_w(dy, dy, -yy) + fma_w(dz, dz, -zz);
  realw yy_of_sum = xy - xx, zz_of_sum = dd - xy;
  rest = rest + (((xx - (xy - yy_of_sum)) + (yy - yy_of_sum)) + ((xy - (dd - zz_of_sum)) + (zz - zz_of_sum)));
  to[RAY_PLANE_DD] = dd;
  to[RAY_PLANE_DD + 1] = rest;
  to[RAY_PLANE_DD + 2] = one / dd;
  to[RAY_PLANE_DD + 3] = splat_w(R(1.0) + R(0x1p-20)) * sqrt_w(one / dd);
#endif
  // The axes of the shear: the one with the largest |d|, the others after it in turn.
  realw ax = abs_w(given->dx), ay = abs_w(given->dy), az = abs_w(given->dz);
  maskw is_x = lt_w(ay, ax) & lt_w(az, ax), is_y = ~lt_w(ay, ax) & lt_w(az, ay);
  realw along = sel_w(is_x, inv_x, sel_w(is_y, inv_y, inv_z));
  to[RAY_PLANE_SHEAR] = sel_w(is_x, zero, sel_w(is_y, one, splat_w(R(2.0))));
  to[RAY_PLANE_SHEAR + 1] = sel_w(is_x, dy, sel_w(is_y, dz, dx)) * along;
  to[RAY_PLANE_SHEAR + 2] = sel_w(is_x, dz, sel_w(is_y, dx, dy)) * along;
  to[RAY_PLANE_SHEAR + 3] = along;
}

/// Widens rays, so that a box within `reach` (centre x y z, half the size x y z) is certainly met wherever a primitive
/// in it is hit. Slabs are widened sideways by 16 u times the largest distance from the origin, a bound on the errors
/// of the primitive and slab tests together (docs/decisions/0008-tree.md). Along an axis on which the ray does not
/// move, signs are exact.
FN void widen_rays_w(maskw has_departed, PRIVATE realw* to, GLOBAL const real* reach) {
  realw ox = to[RAY_PLANE_O], oy = to[RAY_PLANE_O + 1], oz = to[RAY_PLANE_O + 2];
  realw x = abs_w(splat_w(reach[0]) - ox) + splat_w(reach[3]), y = abs_w(splat_w(reach[1]) - oy) + splat_w(reach[4]);
  realw z = abs_w(splat_w(reach[2]) - oz) + splat_w(reach[5]);
  realw aside = splat_w(R(16.0) * real_roundoff()) * largest_of_w(x, y, z);
#if TIER_FAST
  (void)has_departed;
#else
  // Where a ray leaves a surface, its origin may be off the surface by a rounding (of float, where rays are given in
  // float). The shape that was left must still be hit at its other root.
  realw off = splat_w(R(0x1p-20)) * largest_of_w(ox, oy, oz);
  aside = sel_w(has_departed & lt_w(aside, off), off, aside);
#endif
  realw zero = splat_w(R(0.0));
  to[RAY_PLANE_SLACK] = sel_w(eq_w(to[RAY_PLANE_D], zero), zero, aside * abs_w(to[RAY_PLANE_INV]));
  to[RAY_PLANE_SLACK + 1] = sel_w(eq_w(to[RAY_PLANE_D + 1], zero), zero, aside * abs_w(to[RAY_PLANE_INV + 1]));
  to[RAY_PLANE_SLACK + 2] = sel_w(eq_w(to[RAY_PLANE_D + 2], zero), zero, aside * abs_w(to[RAY_PLANE_INV + 2]));
}

#if LANES == 1
#define ONE_BY_ONE
#else
// Of reads that lie LANES apart LLVM makes gathers of four, which take longer than the reads, unless these are
// volatile.
#define ONE_BY_ONE volatile
#endif

FN Ray prepared_ray_w(PRIVATE const realw* from, int lane, int departed) {
  PRIVATE const ONE_BY_ONE real* planes = (PRIVATE const real*)from + lane;
  Ray ray;
  ray.o = vec3(planes[RAY_PLANE_O * LANES], planes[(RAY_PLANE_O + 1) * LANES], planes[(RAY_PLANE_O + 2) * LANES]);
  ray.d = vec3(planes[RAY_PLANE_D * LANES], planes[(RAY_PLANE_D + 1) * LANES], planes[(RAY_PLANE_D + 2) * LANES]);
  ray.t_min = planes[RAY_PLANE_T_MIN * LANES];
  ray.t_max = planes[RAY_PLANE_T_MAX * LANES];
  ray.t_from_scaled = planes[RAY_PLANE_T_FROM_SCALED * LANES];
  ray.departed = TIER_FAST ? -1 : departed;
  ray.departed_instance = -1;
  ray.aim = -1;
  ray.is_outward = 0;
  ray.inv =
      vec3(planes[RAY_PLANE_INV * LANES], planes[(RAY_PLANE_INV + 1) * LANES], planes[(RAY_PLANE_INV + 2) * LANES]);
#if TIER_COMPENSATED
  ray.dd = planes[RAY_PLANE_DD * LANES];
  ray.dd_rest = planes[(RAY_PLANE_DD + 1) * LANES];
  ray.dd_inverse = planes[(RAY_PLANE_DD + 2) * LANES];
  ray.t_per_length = planes[(RAY_PLANE_DD + 3) * LANES];
#endif
  ray.slack = vec3(planes[RAY_PLANE_SLACK * LANES], planes[(RAY_PLANE_SLACK + 1) * LANES],
                   planes[(RAY_PLANE_SLACK + 2) * LANES]);
  ray.near_x = sign_bit(ray.inv.x);
  ray.near_y = 2 + sign_bit(ray.inv.y);
  ray.near_z = 4 + sign_bit(ray.inv.z);
  ray.kz = (int)planes[RAY_PLANE_SHEAR * LANES];
  ray.kx = ray.kz == 2 ? 0 : ray.kz + 1;
  ray.ky = ray.kx == 2 ? 0 : ray.kx + 1;
  ray.shear_x = planes[(RAY_PLANE_SHEAR + 1) * LANES];
  ray.shear_y = planes[(RAY_PLANE_SHEAR + 2) * LANES];
  ray.shear_z = planes[(RAY_PLANE_SHEAR + 3) * LANES];
  return ray;
}
#undef ONE_BY_ONE
