// SPDX-License-Identifier: MIT
// e to negative powers and logarithms of numbers below 1, in lanes, with + - * / fma only, so that every device gives
// the same bits. Polynomials by Chebyshev's nodes. Bounds in ulps of the result, held by tests/cl/test_exp_log.cpp
// against MPFR: 1.0 of exp_minus (worst seen 0.91), 1.0 of minus_log (0.85). One width; no guard.

#if REAL_BITS == 64
#define EXP_LN2_HIGH R(0x1.62e42fefa3800p-1)  // 42 bits: its multiples by exponents are exact.
#define EXP_LN2_LOW R(0x1.ef35793c76730p-45)
#define EXP_ONE_OVER_LN2 R(0x1.71547652b82fep+0)
#define EXP_MOST R(708.0)  // e^-708 is the least power that is no subnormal number.

// (e^-r - 1 + r) / r^2, |r| <= ln(2) / 2: error 2^-59.
FN realw exp_tail_w(realw r) {
  realw p = fma_w(r, splat_w(R(0x1.1f730349868cep-29)), splat_w(R(-0x1.af4de97ca4194p-26)));
  p = fma_w(r, p, splat_w(R(0x1.27e4db646b17ep-22)));
  p = fma_w(r, p, splat_w(R(-0x1.71de0231960ebp-19)));
  p = fma_w(r, p, splat_w(R(0x1.a01a01a6d889cp-16)));
  p = fma_w(r, p, splat_w(R(-0x1.a01a01abe7fe1p-13)));
  p = fma_w(r, p, splat_w(R(0x1.6c16c16c162d4p-10)));
  p = fma_w(r, p, splat_w(R(-0x1.11111111100dcp-7)));
  p = fma_w(r, p, splat_w(R(0x1.5555555555556p-5)));
  p = fma_w(r, p, splat_w(R(-0x1.5555555555557p-3)));
  return fma_w(r, p, splat_w(R(0.5)));
}

// (ln((1 + s) / (1 - s)) / s - 2) / z, z = s^2, |s| <= (sqrt(2) - 1) / (sqrt(2) + 1): error 2^-58.
FN realw log_tail_w(realw z) {
  realw p = fma_w(z, splat_w(R(0x1.0c04595972ab8p-3)), splat_w(R(0x1.0fbe83c2cbcf3p-3)));
  p = fma_w(z, p, splat_w(R(0x1.3b1c360763b8ap-3)));
  p = fma_w(z, p, splat_w(R(0x1.745cf901605f7p-3)));
  p = fma_w(z, p, splat_w(R(0x1.c71c720160b47p-3)));
  p = fma_w(z, p, splat_w(R(0x1.2492492476c87p-2)));
  p = fma_w(z, p, splat_w(R(0x1.9999999999a38p-2)));
  return fma_w(z, p, splat_w(R(0x1.5555555555555p-1)));
}
#else
#define EXP_LN2_HIGH R(0x1.62e400p-1)  // 15 bits.
#define EXP_LN2_LOW R(0x1.7f7d1cp-20)
#define EXP_ONE_OVER_LN2 R(0x1.715476p+0)
#define EXP_MOST R(87.0)

// Error 2^-23.9, of a term that is at most r^2 = 0.12 of the whole.
FN realw exp_tail_w(realw r) {
  realw p = fma_w(r, splat_w(R(0x1.6d110ap-10)), splat_w(R(-0x1.120b6ep-7)));
  p = fma_w(r, p, splat_w(R(0x1.55551ap-5)));
  p = fma_w(r, p, splat_w(R(-0x1.5554dcp-3)));
  return fma_w(r, p, splat_w(R(0.5)));
}

// Error 2^-22.3, of a term that is at most 0.01 of the whole.
FN realw log_tail_w(realw z) {
  realw p = fma_w(z, splat_w(R(0x1.2ee656p-2)), splat_w(R(0x1.997c2ep-2)));
  return fma_w(z, p, splat_w(R(0x1.55555cp-1)));
}
#endif

/// e^-a for a >= 0, infinity included; 0 beyond EXP_MOST.
FN realw exp_minus_w(realw a) {
  realw one = splat_w(R(1.0)), zero = splat_w(R(0.0)), most = splat_w(EXP_MOST);
  maskw is_within = le_w(a, most);
  realw within = sel_w(is_within, a, zero);
  intw n = int_of_real_w(fma_w(within, splat_w(EXP_ONE_OVER_LN2), splat_w(R(0.5))));
  realw times = real_of_uint_w(uint_of_int_w(n));
  realw high = fma_w(-times, splat_w(EXP_LN2_HIGH), within), low = times * splat_w(EXP_LN2_LOW);
  realw r = high - low, rest = (high - r) - low;  // r + rest: to twice the digits.
  realw power = one - (r - fma_w(r * r, exp_tail_w(r), -rest));
  return sel_w(is_within, power * power_of_half_w(n), zero);
}

/// -ln u for u in (0, 1], no subnormal number.
FN realw minus_log_w(realw u) {
  realw one = splat_w(R(1.0)), down = power_of_two_w(u), m = u * inverse_power_w(down), halvings = halvings_w(down);
  maskw is_large = lt_w(splat_w(R(1.4142135623730951)), m);
  m = sel_w(is_large, splat_w(R(0.5)) * m, m);
  halvings = sel_w(is_large, halvings - one, halvings);
  realw f = m - one, s = f / (m + one), z = s * s;
  // ln m = f - s (f - z tail): f is exact and the rest is small beside it.
  realw rest = s * fma_w(-z, log_tail_w(z), f);
  realw low = fma_w(halvings, splat_w(EXP_LN2_LOW), rest);
  return fma_w(halvings, splat_w(EXP_LN2_HIGH), low - f);
}
