// SPDX-License-Identifier: MIT
// Ray against LANES open cylinders, robust tier: the sphere's form in two dimensions, for f x v and d x v instead of f
// and d, v the axis. v is a unit vector that was rounded; the rounded one is taken as exact. The mantle is |f x v| = r
// |v|, from (p - p0).v = 0 to length v.v, so neither radius nor direction depends on |v| being 1.
// (f x v) x (d x v) = (f . (d x v)) v, hence the discriminant is v.v times a r^2 - (f . (d x v))^2.
// A ray parallel to the axis misses. The cylinder just left: the other root, -2 b / a.

/// t of the lanes of `open`, from its range; of the others as it is.
SELDOM_FN realw cylinders_decided_w(const Ray* ray, GLOBAL const real* block, uint open, uint is_near, uint departed,
                                    PRIVATE const realw* least, PRIVATE const realw* most, realw t) {
  for (; open != 0u; open &= open - 1u) {
    int i = first_bit(open);
    GLOBAL const real* prim = block + i;
    ExactCase one;
    one.o = ray->o;
    one.d = ray->d;
    one.a = vec3(prim[0], prim[LANES], prim[2 * LANES]);
    one.b = one.c = vec3(prim[3 * LANES], prim[4 * LANES], prim[5 * LANES]);
    one.r = prim[7 * LANES];
    int root = (departed >> i & 1u) != 0u ? EXACT_ACROSS : (is_near >> i & 1u) != 0u ? EXACT_NEAR : EXACT_FAR;
    put_w(&t, i, exact_root(EXACT_MANTLE, &one, get_w(least, i), get_w(most, i), root));
  }
  return t;
}

/// Takes the nearest of `hit`. least, most: of t, which is decided exactly where they differ; about: t where they do
/// not.
FN void cylinders_take_w(const Ray* ray, GLOBAL const real* block, GLOBAL const int* ids, int slot, maskw hit,
                         maskw is_near, maskw departed, realw least, realw most, realw about, Nearest* best) {
  realw t = about;
  maskw open = hit & is_there_w(ids) & ~eq_w(least, most);
  if (any_w(open))
    t = cylinders_decided_w(ray, block, bits_w(open), bits_w(is_near), bits_w(departed), &least, &most, t);
  take_nearest_w(hit & in_range_w(t, ray, best), t, ids, -1, SHAPE_cylinder, slot, best);
}

#if WIDE_IS_DOUBLE
#define CYLINDERS_IN_DOUBLE_WORDS SELDOM_FN

/// Takes the nearest of those that are hit for certain. Returns the lanes of `which` that double words must decide.
FN maskw cylinders_take_told_w(const Ray* ray, GLOBAL const real* block, GLOBAL const int* ids, int slot, maskw which,
                               Nearest* best) {
  Cylinders_w c = cylinders_of_block_w(block);
  real3w o = splat3_w(ray->o);
  ToldCylinders_w told = cylinders_told_w(o, splat3_w(ray->d), splat_w(ray->t_min), &c, which);
  if (any_w(told.hit)) {
    realw t = narrow_w(told.t), off = cylinder_off_w(o, &c, t, told.a, told.chord, splat_w(WIDE_ROUNDOFF));
    cylinders_take_w(ray, block, ids, slot, told.hit, told.is_near, none_w(), wide_least_w(told.t, off),
                     wide_most_w(told.t, off), t, best);
  }
  return which & ~told.told;
}
#else
#define CYLINDERS_IN_DOUBLE_WORDS FN
#endif

/// The lanes of `which`, in double words, which decide what is hit on every device.
CYLINDERS_IN_DOUBLE_WORDS void cylinders_decide_w(const Ray* ray, GLOBAL const real* block, GLOBAL const int* ids,
                                                  int slot, PRIVATE const maskw* which, PRIVATE const maskw* left,
                                                  Nearest* best) {
  Cylinders_w c = cylinders_of_block_w(block);
  dw3_w f = two_difference3_w(splat_w(ray->o.x), splat_w(ray->o.y), splat_w(ray->o.z), c.foot.x, c.foot.y, c.foot.z);
  realw vx = c.v.x, vy = c.v.y, vz = c.v.z, length = c.length, r = c.r;
  maskw departed = *left;
  realw dx = splat_w(ray->d.x), dy = splat_w(ray->d.y), dz = splat_w(ray->d.z), zero = splat_w(R(0.0));
  dw3_w across, from = cross_real3_w(f, vx, vy, vz);
  across.x = sum3_round_w(sum3_begin_w(dy, vz, -dz, vy));
  across.y = sum3_round_w(sum3_begin_w(dz, vx, -dx, vz));
  across.z = sum3_round_w(sum3_begin_w(dx, vy, -dy, vx));
  dw_w v2 = real_dot_real3_w(vx, vy, vz, vx, vy, vz), r2 = two_prod_w(r, r);
  dw_w a = dw_dot3_w(across, across), b = dw_dot3_w(from, across), apart = dw_dot3_w(f, across);
  dw_w at_o = dw_add_w(dw_dot3_w(from, from), dw_negate_w(dw_mul_w(r2, v2)));
  dw_w discriminant = dw_mul_w(v2, dw_add_w(dw_mul_w(a, r2), dw_negate_w(dw_mul_w(apart, apart))));
  maskw hit = *which & le_w(zero, discriminant.hi) & lt_w(zero, a.hi);

  Roots_w roots = quadratic_roots_w(a, b, at_o, discriminant);
  dw_w o_along = dot_real3_w(f, vx, vy, vz), d_along = real_dot_real3_w(dx, dy, dz, vx, vy, vz);
  dw_w end = dw_negate_w(dw_scale_w(v2, length));
  dw_w along = dw_add_w(o_along, dw_mul_w(roots.near, d_along));
  maskw near_hit =
      le_w(splat_w(ray->t_min), roots.near.hi) & le_w(zero, along.hi) & le_w(dw_add_w(along, end).hi, zero);
  dw_w t = dw_sel_w(near_hit, roots.near, roots.far);

  dw_w other = dw_scale_w(dw_div_w(b, a), splat_w(-R(2.0)));
  t = dw_sel_w(departed, other, t);
  along = dw_add_w(o_along, dw_mul_w(t, d_along));
  hit = (hit & ~departed) | (departed & lt_w(zero, other.hi));
  if (ray->departed >= 0) hit = hit & (~departed | within_cylinder_slabs_w(ray, block, t.hi));
  hit = hit & le_w(zero, along.hi) & le_w(dw_add_w(along, end).hi, zero);
  realw half_chord = sqrt_w(discriminant.hi) / a.hi;
  half_chord = sel_w(departed, splat_w(REAL_MAX), half_chord);
  realw off = cylinder_off_w(splat3_w(ray->o), &c, t.hi, a.hi, half_chord, splat_w(DOUBLE_WORD_ROUNDOFF));
  cylinders_take_w(ray, block, ids, slot, hit, near_hit, departed, t.hi + (t.lo - off), t.hi + (t.lo + off), t.hi,
                   best);
}
#undef CYLINDERS_IN_DOUBLE_WORDS

FN void cylinder_block_w(const Ray* ray, GLOBAL const real* block, GLOBAL const int* ids, int slot, Nearest* best) {
  Cylinders_w c = cylinders_of_block_w(block);
  real3w f = sub3_w(splat3_w(ray->o), c.foot);
  maskw which = within_reach_w(ray, best, f.x, f.y, f.z, c.r + c.length) &
                near_mantle_w(splat3_w(ray->d), splat_w(ray->t_min), splat_w(best->t), f, &c);
  maskw departed = none_w();
  if (ray->departed >= 0) departed = is_departed_w(ids, ray);
  // Padding is a point without an axis: NaN passes. What a ray ends on is aimed at from outside.
  if (any_w(which)) which = which & ~departed & is_there_w(ids) & nonzero_w(load_int_w(ids) - splat_int_w(ray->aim));
  if (ray->is_outward) departed = none_w();
#if WIDE_IS_DOUBLE
  if (any_w(which)) which = cylinders_take_told_w(ray, block, ids, slot, which, best);
#endif
  if (any_w(which | departed)) cylinders_decide_w(ray, block, ids, slot, &which, &departed, best);
}
