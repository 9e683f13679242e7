// SPDX-License-Identifier: MIT
// Which open cylinders rays may meet, robust tier, a ray and a cylinder a lane, for blocks and for packets. One width;
// no guard.

typedef struct {
  real3w foot, v;  ///< v: along the axis, a rounded unit vector.
  realw length, r;
} Cylinders_w;

FN Cylinders_w cylinders_of_block_w(GLOBAL const real* block) {
  Cylinders_w c;
  c.foot = load_planes3_w(block);
  c.v = load_planes3_w(block + 3 * LANES);
  c.length = load_w(block + 6 * LANES);
  c.r = load_w(block + 7 * LANES);
  return c;
}

/// Lanes whose mantle the ray may meet in its range, up to the best hit so far: those whose axis the line passes within
/// r, in that range, and between the ends. Distance times |d x v| and the place k of the line's point nearest to the
/// axis are off by less than 16 u, in terms of |f| and of |f| / |d x v|; 2^-18 is 64 u. NaN passes.
FN maskw near_mantle_w(real3w d, realw t_min, realw t_max, real3w f, const Cylinders_w* c) {
  real3w v = c->v, n = cross3_w(d, v), from = cross3_w(f, v);
  realw length = c->length, r = c->r;
  realw size = size1_w(f), some = splat_w(R(0x1p-18)), distance = dot3_w(f, n), across = dot3_w(n, n);
  realw limit = fma_w(some, size, r);
  maskw passes_by = lt_w(limit * limit * across + splat_w(R(0x1p-120)), distance * distance);

  realw k = -dot3_w(from, n) / across, reach = fma_w(some, limit, limit) / sqrt_w(across);
  maskw beyond = lt_w(t_max, k - reach) | lt_w(k + reach, t_min);

  realw d_along = dot3_w(d, v), along = fma_w(k, d_along, dot3_w(f, v));
  realw spare = fma_w(some, size + length + abs_w(k) + abs_w(k), abs_w(d_along) * reach);
  maskw past_ends = lt_w(along + spare, splat_w(R(0.0))) | lt_w(length + spare, along);
  return ~(passes_by | beyond | past_ends);
}

/// How far t may be off, or a NaN where that is not known. roundoff: of the arithmetic, per operation. a: |d x v|^2.
/// With A = |d x v|, s = (|f| + r) |v| / A, norms of f and v being sums of absolute values, and h half the chord, t is
/// off by less than 4 roundoff (s + |t|) (1 + r |v| / (A h)) where A >= 2^-20 |d| |v|: of u^2, a quarter of a double
/// word's roundoff, 14 for each dot product and 28 for the discriminant; -2 b / a by twice that for an infinite h.
FN realw cylinder_off_w(real3w o, const Cylinders_w* c, realw t, realw a, realw chord, realw roundoff) {
  realw r = c->r, length_v = size1_w(c->v), across = sqrt_w(a);
  realw s = (size1_w(sub3_w(o, c->foot)) + r) * length_v / across + abs_w(t);
  realw off = splat_w(R(16.0)) * roundoff * fma_w(s, r * length_v / (across * chord), s);
  maskw is_known = lt_w(splat_w(R(0x1p-36)) * length_v * length_v, a) & lt_w(splat_w(R(0x1p-60)), r) &
                   lt_w(splat_w(R(0x1p-60)), s) & lt_w(off, splat_w(R(0x1p-10)) * chord);
  return sel_w(is_known, off, splat_w(exact_nothing()));
}

#if WIDE_IS_DOUBLE
#include "shapes/cylinder/cylinder_doubles_lanes.h"
#endif
