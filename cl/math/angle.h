// SPDX-License-Identifier: MIT
// Angles in turns: sine and cosine, and the angle of a vector, with + - * / fma only, so that every device gives the
// same bits (the built-ins' rounding is the implementation's). Turns make the reduction exact: no multiple of pi is
// subtracted. Polynomials: minimax by Remez exchange (relative error, 60 digits), each coefficient rounded to the tier
// before the next is fitted; the leading factor 2 pi or 1 / 2 pi is split in two, so that its rounding does not count.
// Bounds in both tiers, held by tests/cl/test_angle.cpp against MPFR, in ulps of the result:
//   sincos_turns 0.80 (worst seen 0.789)    atan2_turns 1.75 (worst seen 1.65)
#ifndef STRAHL_MATH_ANGLE_H
#define STRAHL_MATH_ANGLE_H

#if REAL_BITS == 64
#define ANGLE_TWO_PI_HIGH R(0x1.921fb54442d18p+2)
#define ANGLE_TWO_PI_LOW R(0x1.1a62633145c07p-52)
#define ANGLE_TURN_HIGH R(0x1.45f306dc9c883p-3)
#define ANGLE_TURN_LOW R(-0x1.6b01ec5417056p-57)
#define ANGLE_COS_QUADRATIC R(-0x1.3bd3cc9be45dep+4)
#define ANGLE_INTEGERS_FROM R(0x1p+52)
#define ANGLE_BELOW_ONE R(0x1.fffffffffffffp-1)
#define ANGLE_HUGE R(0x1p+1022)

// (sin(2 pi f) / f - 2 pi) / f^2, z = f^2 <= 1/64; relative error of the sine 2^-57.9.
FN real angle_sin_tail(real z) {
  real p = real_fma(z, R(0x1.e3fbc8088ac84p+1), R(-0x1.e3008f6e25c46p+3));
  p = real_fma(z, p, R(0x1.5078300313c8cp+5));
  p = real_fma(z, p, R(-0x1.32d2cce31bcd9p+6));
  p = real_fma(z, p, R(0x1.466bc67758c4bp+6));
  return real_fma(z, p, R(-0x1.4abbce625be46p+5));
}

// ((cos(2 pi f) - 1) / f^2 - quadratic) / f^2; relative error of the cosine 2^-59.2.
FN real angle_cos_tail(real z) {
  real p = real_fma(z, R(-0x1.b0340c645a70dp+0), R(0x1.f9c4ad833b377p+2));
  p = real_fma(z, p, R(-0x1.a6d1e238aff46p+4));
  p = real_fma(z, p, R(0x1.e1f50675b1d6ep+5));
  p = real_fma(z, p, R(-0x1.55d3c7e3bfe55p+6));
  return real_fma(z, p, R(0x1.03c1f081b5a52p+6));
}

// (atan(t) / t - 1) / (2 pi t^2), z = t^2 <= tan(pi / 8)^2; relative error of the angle 2^-59.0.
FN real angle_atan_tail(real z) {
  real p = real_fma(z, R(-0x1.758777a1b7401p-9), R(0x1.8cff5c2770209p-8));
  p = real_fma(z, p, R(-0x1.06ccec8305fb2p-7));
  p = real_fma(z, p, R(0x1.30f9dd4fe35e6p-7));
  p = real_fma(z, p, R(-0x1.5b7e3b0cdee11p-7));
  p = real_fma(z, p, R(0x1.9127cbc6b0ff0p-7));
  p = real_fma(z, p, R(-0x1.da1b85ffa5a6ap-7));
  p = real_fma(z, p, R(0x1.21bb93c2364afp-6));
  p = real_fma(z, p, R(-0x1.7483758bfb733p-6));
  p = real_fma(z, p, R(0x1.04c26be3adcd8p-5));
  return real_fma(z, p, R(-0x1.b2995e7b7b5e4p-5));
}
#else
#define ANGLE_TWO_PI_HIGH R(0x1.921fb6p+2)
#define ANGLE_TWO_PI_LOW R(-0x1.777a5cp-23)
#define ANGLE_TURN_HIGH R(0x1.45f306p-3)
#define ANGLE_TURN_LOW R(0x1.b93910p-28)
#define ANGLE_COS_QUADRATIC R(-0x1.3bd3ccp+4)
#define ANGLE_INTEGERS_FROM R(0x1p+23)
#define ANGLE_BELOW_ONE R(0x1.fffffep-1)
#define ANGLE_HUGE R(0x1p+126)

// As above, relative errors 2^-27.9, 2^-31.1 and 2^-28.7.
FN real angle_sin_tail(real z) {
  real p = real_fma(z, R(-0x1.2db5d6p+6), R(0x1.465facp+6));
  return real_fma(z, p, R(-0x1.4abbbep+5));
}

FN real angle_cos_tail(real z) {
  real p = real_fma(z, R(0x1.d4f7f0p+5), R(-0x1.55b2b6p+6));
  return real_fma(z, p, R(0x1.03c1b0p+6));
}

FN real angle_atan_tail(real z) {
  real p = real_fma(z, R(-0x1.3b5caap-7), R(0x1.13f240p-6));
  p = real_fma(z, p, R(-0x1.735ffep-6));
  p = real_fma(z, p, R(0x1.04bd12p-5));
  return real_fma(z, p, R(-0x1.b2994ep-5));
}
#endif

/// Sine and cosine of f turns, |f| <= 1/8.
FN void sincos_eighth(real f, real* sine, real* cosine) {
  const real z = f * f;
  const real z_error = real_fma(f, f, -z);
  const real cos_tail = real_fma(z_error, ANGLE_COS_QUADRATIC, z * z * angle_cos_tail(z));
  *sine = real_fma(f, ANGLE_TWO_PI_HIGH, f * real_fma(z, angle_sin_tail(z), ANGLE_TWO_PI_LOW));
  *cosine = R(1.0) + real_fma(z, ANGLE_COS_QUADRATIC, cos_tail);
}

/// Sine and cosine of a finite angle in turns; exact at every multiple of a quarter.
FN void sincos_turns(real turns, real* sine, real* cosine) {
  const real a = real_abs(turns);
  // Adding the first number whose neighbours are 1 apart rounds to an integer; whatever is larger is one already.
  const real whole = a < ANGLE_INTEGERS_FROM ? (a + ANGLE_INTEGERS_FROM) - ANGLE_INTEGERS_FROM : a;
  const real part = a - whole;
  const real shift = R(1.5) * ANGLE_INTEGERS_FROM;
  const real quarters = (R(4.0) * part + shift) - shift;
  real s, c;
  sincos_eighth(part - R(0.25) * quarters, &s, &c);  // Exact, as everything before it.

  const int quadrant = (int)quarters & 3;
  const real sin_a = (quadrant & 1) ? c : s;
  const real cos_a = (quadrant & 1) ? s : c;
  const int sine_is_negative = ((quadrant & 2) != 0) != (turns < R(0.0));
  const int cosine_is_negative = quadrant == 1 || quadrant == 2;
  *sine = sine_is_negative ? -sin_a : sin_a;
  *cosine = cosine_is_negative ? -cos_a : cos_a;
}

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
