// SPDX-License-Identifier: MIT
// Sine and cosine of angles in turns, with + - * fma only, so that every device gives the same bits (the built-ins'
// rounding is the implementation's). Turns make the reduction exact: no multiple of pi is subtracted. Polynomials as in
// math/angle.h, the leading factor 2 pi split in two. Bound in both tiers, held by tests/cl/test_angle.cpp against
// MPFR: 0.80 ulps of the result (worst seen 0.789). One width; no guard.

// The tails: (sin(2 pi f) / f - 2 pi) / f^2 and ((cos(2 pi f) - 1) / f^2 - quadratic) / f^2, z = f^2 <= 1/64.
#if REAL_BITS == 64
#define SINCOS_TWO_PI_HIGH R(0x1.921fb54442d18p+2)
#define SINCOS_TWO_PI_LOW R(0x1.1a62633145c07p-52)
#define SINCOS_QUADRATIC R(-0x1.3bd3cc9be45dep+4)
#define SINCOS_INTEGERS_FROM R(0x1p+52)

// Relative error of the sine 2^-57.9, of the cosine 2^-59.2.
FN realw sine_tail_w(realw z) {
  realw p = fma_w(z, splat_w(R(0x1.e3fbc8088ac84p+1)), splat_w(R(-0x1.e3008f6e25c46p+3)));
  p = fma_w(z, p, splat_w(R(0x1.5078300313c8cp+5)));
  p = fma_w(z, p, splat_w(R(-0x1.32d2cce31bcd9p+6)));
  p = fma_w(z, p, splat_w(R(0x1.466bc67758c4bp+6)));
  return fma_w(z, p, splat_w(R(-0x1.4abbce625be46p+5)));
}

FN realw cosine_tail_w(realw z) {
  realw p = fma_w(z, splat_w(R(-0x1.b0340c645a70dp+0)), splat_w(R(0x1.f9c4ad833b377p+2)));
  p = fma_w(z, p, splat_w(R(-0x1.a6d1e238aff46p+4)));
  p = fma_w(z, p, splat_w(R(0x1.e1f50675b1d6ep+5)));
  p = fma_w(z, p, splat_w(R(-0x1.55d3c7e3bfe55p+6)));
  return fma_w(z, p, splat_w(R(0x1.03c1f081b5a52p+6)));
}
#else
#define SINCOS_TWO_PI_HIGH R(0x1.921fb6p+2)
#define SINCOS_TWO_PI_LOW R(-0x1.777a5cp-23)
#define SINCOS_QUADRATIC R(-0x1.3bd3ccp+4)
#define SINCOS_INTEGERS_FROM R(0x1p+23)

// 2^-27.9 and 2^-31.1.
FN realw sine_tail_w(realw z) {
  realw p = fma_w(z, splat_w(R(-0x1.2db5d6p+6)), splat_w(R(0x1.465facp+6)));
  return fma_w(z, p, splat_w(R(-0x1.4abbbep+5)));
}

FN realw cosine_tail_w(realw z) {
  realw p = fma_w(z, splat_w(R(0x1.d4f7f0p+5)), splat_w(R(-0x1.55b2b6p+6)));
  return fma_w(z, p, splat_w(R(0x1.03c1b0p+6)));
}
#endif

typedef struct {
  realw sine, cosine;
} SinCos_w;

/// Of f turns, |f| <= 1/8.
FN SinCos_w sincos_eighth_w(realw f) {
  SinCos_w result;
  realw z = f * f, quadratic = splat_w(SINCOS_QUADRATIC);
  realw z_error = fma_w(f, f, -z);
  realw tail = fma_w(z_error, quadratic, z * z * cosine_tail_w(z));
  realw rest = f * fma_w(z, sine_tail_w(z), splat_w(SINCOS_TWO_PI_LOW));
  result.sine = fma_w(f, splat_w(SINCOS_TWO_PI_HIGH), rest);
  result.cosine = splat_w(R(1.0)) + fma_w(z, quadratic, tail);
  return result;
}

#if TIER_FAST
/// Of 0 <= a < 2^23.
FN realw nearest_integer_w(realw a) { return real_of_uint_w(uint_of_int_w(int_of_real_w(a + splat_w(R(0.5))))); }
#endif

/// Of a finite angle in turns; exact at every multiple of a quarter.
FN SinCos_w sincos_turns_w(realw turns) {
  realw a = abs_w(turns), zero = splat_w(R(0.0)), one = splat_w(R(1.0)), from = splat_w(SINCOS_INTEGERS_FROM);
#if TIER_FAST
  // A compiler that may reassociate cancels what the other tiers add and subtract.
  realw whole = nearest_integer_w(a), part = a - whole;
  realw quarters = nearest_integer_w(splat_w(R(4.0)) * part + splat_w(R(4.0))) - splat_w(R(4.0));
  (void)from;
#else
  // Adding the first number whose neighbours are 1 apart rounds to an integer; larger numbers are integers already.
  realw whole = sel_w(lt_w(a, from), (a + from) - from, a), part = a - whole;
  realw shift = splat_w(R(1.5)) * from, quarters = (splat_w(R(4.0)) * part + shift) - shift;
#endif
  SinCos_w result = sincos_eighth_w(part - splat_w(R(0.25)) * quarters);  // Exact, as everything before it.

  // quarters: -2 ... 2, where -2 and 2 are the same half turn.
  maskw is_odd = eq_w(abs_w(quarters), one), is_half = eq_w(abs_w(quarters), splat_w(R(2.0)));
  realw sine = sel_w(is_odd, result.cosine, result.sine), cosine = sel_w(is_odd, result.sine, result.cosine);
  maskw is_third = eq_w(quarters, -one), is_first = eq_w(quarters, one), is_turned = lt_w(turns, zero);
  maskw is_down = is_half | is_third;
  is_down = (is_down & ~is_turned) | (~is_down & is_turned);
  result.sine = sel_w(is_down, -sine, sine);
  result.cosine = sel_w(is_first | is_half, -cosine, cosine);
  return result;
}
