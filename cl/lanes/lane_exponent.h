// SPDX-License-Identifier: MIT
// Exponents, infinity and NaN of lanes, read from the bits, so that no compiler can assume that there is no infinity or
// NaN. Included by lane_ops.h.
#define EXPONENT_BITS ((bitsr)REAL_EXPONENT_MASK << REAL_EXPONENT_SHIFT)
#define EXPONENT_LEAST ((bitsr)1 << REAL_EXPONENT_SHIFT)
#define EXPONENT_MOST ((bitsr)(REAL_EXPONENT_MASK - 2) << REAL_EXPONENT_SHIFT)
#define EXPONENT_ONE ((bitsr)(REAL_EXPONENT_MASK >> 1))
#define EXPONENT_SUM ((bitsr)(REAL_EXPONENT_MASK - 1) << REAL_EXPONENT_SHIFT)

#if LANES == 1
FN realw power_of_two_w(realw x) {
  bitsr e = real_to_bits(x) & EXPONENT_BITS;
  if (e < EXPONENT_LEAST) e = EXPONENT_LEAST;
  if (EXPONENT_MOST < e) e = EXPONENT_MOST;
  return bits_to_real(e);
}
FN realw inverse_power_w(realw p) { return bits_to_real(EXPONENT_SUM - real_to_bits(p)); }
FN realw power_of_half_w(intw n) { return bits_to_real((EXPONENT_ONE - (bitsr)n) << REAL_EXPONENT_SHIFT); }
FN realw halvings_w(realw p) { return (real)(int)(EXPONENT_ONE - (real_to_bits(p) >> REAL_EXPONENT_SHIFT)); }
FN maskw finite_w(realw x) { return -(int)((real_to_bits(x) << 1) < (EXPONENT_BITS << 1)); }
FN maskw nan_w(realw x) { return -(int)((EXPONENT_BITS << 1) < (real_to_bits(x) << 1)); }
#else
FN realw power_of_two_w(realw x) {
  maskw e = LANE_AS_MASK(x) & LANE_SPLAT_MASK(EXPONENT_BITS);
  maskw least = LANE_SPLAT_MASK(EXPONENT_LEAST), most = LANE_SPLAT_MASK(EXPONENT_MOST);
  maskw is_small = e < least, is_large = most < e;
  e = (e & ~is_small) | (least & is_small);
  return LANE_AS_REAL((e & ~is_large) | (most & is_large));
}
FN realw inverse_power_w(realw p) { return LANE_AS_REAL(LANE_SPLAT_MASK(EXPONENT_SUM) - LANE_AS_MASK(p)); }
FN realw power_of_half_w(intw n) {
  return LANE_AS_REAL((LANE_SPLAT_MASK(EXPONENT_ONE) - LANE_TO_MASK(n)) << REAL_EXPONENT_SHIFT);
}
FN realw halvings_w(realw p) {
  return LANE_TO_REAL(LANE_SPLAT_MASK(EXPONENT_ONE) - (LANE_AS_MASK(p) >> REAL_EXPONENT_SHIFT));
}
FN maskw finite_w(realw x) { return LANE_AS_MASK(abs_w(x)) < LANE_SPLAT_MASK(EXPONENT_BITS); }
FN maskw nan_w(realw x) { return LANE_SPLAT_MASK(EXPONENT_BITS) < LANE_AS_MASK(abs_w(x)); }
#endif

#undef EXPONENT_BITS
#undef EXPONENT_LEAST
#undef EXPONENT_MOST
#undef EXPONENT_ONE
#undef EXPONENT_SUM
