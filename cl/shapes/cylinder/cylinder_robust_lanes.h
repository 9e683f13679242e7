// SPDX-License-Identifier: MIT
// Ray against LANES open cylinders, robust tier: the sphere's form in two dimensions, for f x v and d x v instead of f
// and d, v the axis. v is a unit vector that was rounded; the rounded one is taken as exact. The mantle is |f x v| = r
// |v|, from (p - p0).v = 0 to length v.v, so neither radius nor direction depends on |v| being 1.
// (f x v) x (d x v) = (f . (d x v)) v, hence the discriminant is v.v times a r^2 - (f . (d x v))^2.
// A ray parallel to the axis misses. The cylinder just left: the other root, -2 b / a.

/// Lanes whose mantle the ray may meet in its range, up to the best hit so far: those whose axis the line passes within
/// r, in that range, and between the ends. Distance times |d x v| and the place k of the line's point nearest to the
/// axis are off by less than 16 u, in terms of |f| and of |f| / |d x v|; 2^-18 is 64 u. NaN passes.
FN maskw near_mantle_w(const Ray* ray, const Nearest* best, real3w f, real3w v, realw length, realw r) {
  real3w d = splat3_w(ray->d), n = cross3_w(d, v), from = cross3_w(f, v);
  realw size = size1_w(f), some = splat_w(R(0x1p-18)), distance = dot3_w(f, n), across = dot3_w(n, n);
  realw limit = fma_w(some, size, r);
  maskw passes_by = lt_w(limit * limit * across + splat_w(R(0x1p-120)), distance * distance);

  realw k = -dot3_w(from, n) / across, reach = fma_w(some, limit, limit) / sqrt_w(across);
  maskw beyond = lt_w(splat_w(best->t), k - reach) | lt_w(k + reach, splat_w(ray->t_min));

  realw d_along = dot3_w(d, v), along = fma_w(k, d_along, dot3_w(f, v));
  realw spare = fma_w(some, size + length + abs_w(k) + abs_w(k), abs_w(d_along) * reach);
  maskw past_ends = lt_w(along + spare, splat_w(R(0.0))) | lt_w(length + spare, along);
  return ~(passes_by | beyond | past_ends);
}

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

/// How far t may be off, or a NaN where that is not known. roundoff: of the arithmetic, per operation. a: |d x v|^2.
/// With A = |d x v|, s = (|f| + r) |v| / A, norms of f and v being sums of absolute values, and h half the chord, t is
/// off by less than 4 roundoff (s + |t|) (1 + r |v| / (A h)) where A >= 2^-20 |d| |v|: of u^2, a quarter of a double
/// word's roundoff, 14 for each dot product and 28 for the discriminant; -2 b / a by twice that for an infinite h.
FN realw cylinder_off_w(const Ray* ray, GLOBAL const real* block, realw t, realw a, realw chord, realw roundoff) {
  real3w foot = load_planes3_w(block), v = load_planes3_w(block + 3 * LANES);
  realw r = load_w(block + 7 * LANES), length_v = size1_w(v), across = sqrt_w(a);
  realw s = (size1_w(sub3_w(splat3_w(ray->o), foot)) + r) * length_v / across + abs_w(t);
  realw off = splat_w(R(16.0)) * roundoff * fma_w(s, r * length_v / (across * chord), s);
  maskw is_known = lt_w(splat_w(R(0x1p-36)) * length_v * length_v, a) & lt_w(splat_w(R(0x1p-60)), r) &
                   lt_w(splat_w(R(0x1p-60)), s) & lt_w(off, splat_w(R(0x1p-10)) * chord);
  return sel_w(is_known, off, splat_w(exact_nothing()));
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
#include "shapes/cylinder/cylinder_doubles_lanes.h"
#else
#define CYLINDERS_IN_DOUBLE_WORDS FN
#endif

/// The lanes of `which`, in double words, which decide what is hit on every device.
CYLINDERS_IN_DOUBLE_WORDS void cylinders_decide_w(const Ray* ray, GLOBAL const real* block, GLOBAL const int* ids,
                                                  int slot, PRIVATE const maskw* which, PRIVATE const maskw* left,
                                                  Nearest* best) {
  dw3_w f = two_difference3_w(splat_w(ray->o.x), splat_w(ray->o.y), splat_w(ray->o.z), load_w(block),
                              load_w(block + LANES), load_w(block + 2 * LANES));
  realw vx = load_w(block + 3 * LANES), vy = load_w(block + 4 * LANES), vz = load_w(block + 5 * LANES);
  realw length = load_w(block + 6 * LANES), r = load_w(block + 7 * LANES);
  maskw departed = *left;
  realw dx = splat_w(ray->d.x), dy = splat_w(ray->d.y), dz = splat_w(ray->d.z), zero = splat_w(R(0.0));
  dw3_w across, from = cross_real3_w(f, vx, vy, vz);
  across.x = sum3_round_w(sum3_begin_w(dy, vz, -dz, vy));
  across.y = sum3_round_w(sum3_begin_w(dz, vx, -dx, vz));
  across.z = sum3_round_w(sum3_begin_w(dx, vy, -dy, vx));
  dw_w v2 = real_dot_real3_w(vx, vy, vz, vx, vy, vz), r2 = two_prod_w(r, r);
  dw_w a = dw_dot3_w(across, across), b = dw_dot3_w(from, across), apart = dw_dot3_w(f, across);
  dw_w c = dw_add_w(dw_dot3_w(from, from), dw_negate_w(dw_mul_w(r2, v2)));
  dw_w discriminant = dw_mul_w(v2, dw_add_w(dw_mul_w(a, r2), dw_negate_w(dw_mul_w(apart, apart))));
  maskw hit = *which & le_w(zero, discriminant.hi) & lt_w(zero, a.hi);

  Roots_w roots = quadratic_roots_w(a, b, c, discriminant);
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
  realw off = cylinder_off_w(ray, block, t.hi, a.hi, half_chord, splat_w(DOUBLE_WORD_ROUNDOFF));
  cylinders_take_w(ray, block, ids, slot, hit, near_hit, departed, t.hi + (t.lo - off), t.hi + (t.lo + off), t.hi,
                   best);
}
#undef CYLINDERS_IN_DOUBLE_WORDS

FN void cylinder_block_w(const Ray* ray, GLOBAL const real* block, GLOBAL const int* ids, int slot, Nearest* best) {
  real3w f = sub3_w(splat3_w(ray->o), load_planes3_w(block)), v = load_planes3_w(block + 3 * LANES);
  realw length = load_w(block + 6 * LANES), r = load_w(block + 7 * LANES);
  maskw which = within_reach_w(ray, best, f.x, f.y, f.z, r + length) & near_mantle_w(ray, best, f, v, length, r);
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
