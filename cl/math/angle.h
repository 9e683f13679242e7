// SPDX-License-Identifier: MIT
// The angle of a vector, in turns, with + - * / fma only, so that every device gives the same bits (the built-ins'
// rounding is the implementation's). Polynomial: minimax by Remez exchange (relative error, 60 digits), each
// coefficient rounded to the tier before the next is fitted; the leading factor 1 / 2 pi is split in two, so that its
// rounding does not count. Bound in both tiers, held by tests/cl/test_angle.cpp against MPFR: 1.75 ulps of the result
// (worst seen 1.65).
#ifndef STRAHL_MATH_ANGLE_H
#define STRAHL_MATH_ANGLE_H

#define ONE_OVER_TWO_PI R(0.159154943091895335769)

#if REAL_BITS == 64
#define ANGLE_TURN_HIGH R(0x1.45f306dc9c883p-3)
#define ANGLE_TURN_LOW R(-0x1.6b01ec5417056p-57)
#define ANGLE_BELOW_ONE R(0x1.fffffffffffffp-1)
#define ANGLE_HUGE R(0x1p+1022)

// (atan(t) / t - 1) / (2 pi t^2), z = t^2 <= tan(pi / 8)^2; relative error of the angle 2^-59.0. FIRST(c): the tail is
// c; NEXT(c): the tail times z, plus c.
#define ANGLE_ATAN_TAIL(FIRST, NEXT) \
  FIRST(R(-0x1.758777a1b7401p-9))    \
  NEXT(R(0x1.8cff5c2770209p-8))      \
  NEXT(R(-0x1.06ccec8305fb2p-7))     \
  NEXT(R(0x1.30f9dd4fe35e6p-7))      \
  NEXT(R(-0x1.5b7e3b0cdee11p-7))     \
  NEXT(R(0x1.9127cbc6b0ff0p-7))      \
  NEXT(R(-0x1.da1b85ffa5a6ap-7))     \
  NEXT(R(0x1.21bb93c2364afp-6))      \
  NEXT(R(-0x1.7483758bfb733p-6))     \
  NEXT(R(0x1.04c26be3adcd8p-5))      \
  NEXT(R(-0x1.b2995e7b7b5e4p-5))
#else
#define ANGLE_TURN_HIGH R(0x1.45f306p-3)
#define ANGLE_TURN_LOW R(0x1.b93910p-28)
#define ANGLE_BELOW_ONE R(0x1.fffffep-1)
#define ANGLE_HUGE R(0x1p+126)

// As above, 2^-28.7.
#define ANGLE_ATAN_TAIL(FIRST, NEXT) \
  FIRST(R(-0x1.3b5caap-7))           \
  NEXT(R(0x1.13f240p-6))             \
  NEXT(R(-0x1.735ffep-6))            \
  NEXT(R(0x1.04bd12p-5))             \
  NEXT(R(-0x1.b2994ep-5))
#endif

#define ANGLE_FIRST(c) real tail = c;
#define ANGLE_NEXT(c) tail = real_fma(z, tail, c);
FN real angle_atan_tail(real z) {
  ANGLE_ATAN_TAIL(ANGLE_FIRST, ANGLE_NEXT)
  return tail;
}
#undef ANGLE_FIRST
#undef ANGLE_NEXT

/// The angle of (x, y), finite, from the x axis towards the y axis, in [0, 1) turns; 0 for (0, 0).
/// An angle that rounds to 1 becomes the largest number below, so that the order of angles holds.
FN real atan2_turns(real y, real x) {
  const real ax = real_abs(x), ay = real_abs(y);
  const int is_steep = ay > ax;
  real high = is_steep ? ay : ax;
  real low = is_steep ? ax : ay;
  if (high == R(0.0)) return R(0.0);
  if (high >= ANGLE_HUGE) {
    high *= R(0.25);
    low *= R(0.25);
  }
  const int is_diagonal = low > R(0.41421356237309505) * high;
  const real t = is_diagonal ? (low - high) / (low + high) : low / high;
  const real z = t * t;
  const real a = real_fma(t, ANGLE_TURN_HIGH, t * real_fma(z, angle_atan_tail(z), ANGLE_TURN_LOW));

  // The angle is base + a or base - a, base an exact multiple of 1/8: one rounding.
  real base = is_diagonal ? R(0.125) : R(0.0);
  int is_minus = 0;
  if (is_steep) {
    base = R(0.25) - base;
    is_minus = !is_minus;
  }
  if (x < R(0.0)) {
    base = R(0.5) - base;
    is_minus = !is_minus;
  }
  if (y < R(0.0)) {
    base = R(1.0) - base;
    is_minus = !is_minus;
  }
  const real angle = is_minus ? base - a : base + a;
  return angle < R(1.0) ? angle : ANGLE_BELOW_ONE;
}

#endif
