// SPDX-License-Identifier: MIT
// Numbers well beyond single precision, one width; no guard: doubles where the device has them (WIDE_IS_DOUBLE), else
// double words. Bodies are written once; what they round to single precision in the end is tested (wide_range_w), so
// the bits do not depend on which it is (docs/decisions/0023-correctly-rounded-t.md).
//
// Every operation is within WIDE_ROUNDOFF of its result: doubles by IEEE 754; of double words division is the worst,
// 12 u^2 < 2^-44, barring underflow.

#ifndef WIDE_ROUNDOFF
#define WIDE_ROUNDOFF (WIDE_IS_DOUBLE ? R(0x1p-53) : DOUBLE_WORD_ROUNDOFF)
#endif

#if WIDE_IS_DOUBLE
#if LANES == 1
typedef double wide_w;
FN wide_w wide_of_w(realw x) { return (double)x; }
FN realw narrow_w(wide_w x) { return (real)x; }
FN wide_w wide_root_w(wide_w x) { return wide_sqrt(x); }
#elif ON_HOST
typedef double wide_w __attribute__((vector_size(LANES * sizeof(double))));
FN wide_w wide_of_w(realw x) { return __builtin_convertvector(x, wide_w); }
FN realw narrow_w(wide_w x) { return __builtin_convertvector(x, realw); }
FN wide_w wide_root_w(wide_w x) {
  wide_w root = x;
  for (int i = 0; i < LANES; ++i) root[i] = wide_sqrt(x[i]);
  return root;
}
#else
typedef LANE_VECTOR(double) wide_w;
FN wide_w wide_of_w(realw x) { return LANE_VECTOR(convert_double)(x); }
FN realw narrow_w(wide_w x) { return LANE_VECTOR(convert_float)(x); }
FN wide_w wide_root_w(wide_w x) { return sqrt(x); }
#endif

FN wide_w wide_add_w(wide_w x, wide_w y) { return x + y; }
FN wide_w wide_subtract_w(wide_w x, wide_w y) { return x - y; }
FN wide_w wide_multiply_w(wide_w x, wide_w y) { return x * y; }
FN wide_w wide_negate_w(wide_w x) { return -x; }
FN wide_w wide_scale_w(wide_w x, realw y) { return x * wide_of_w(y); }
FN wide_w wide_divide_w(wide_w x, wide_w y) { return x / y; }
FN wide_w wide_difference_w(realw x, realw y) { return wide_of_w(x) - wide_of_w(y); }
FN wide_w wide_product_w(realw x, realw y) { return wide_of_w(x) * wide_of_w(y); }
FN wide_w wide_of_dw_w(dw_w x) { return wide_of_w(x.hi) + wide_of_w(x.lo); }
/// m ? x : y.
FN wide_w wide_sel_w(maskw m, wide_w x, wide_w y) {
  wide_w share = wide_of_w(sel_w(m, splat_w(R(1.0)), splat_w(R(0.0))));
  return x * share + y * (wide_of_w(splat_w(R(1.0))) - share);
}
FN realw wide_least_w(wide_w x, realw off) { return narrow_w(x - wide_of_w(off)); }
FN realw wide_most_w(wide_w x, realw off) { return narrow_w(x + wide_of_w(off)); }
#else
typedef dw_w wide_w;
FN wide_w wide_of_w(realw x) {
  dw_w wide;
  wide.hi = x;
  wide.lo = splat_w(R(0.0));
  return wide;
}
FN wide_w wide_negate_w(wide_w x) { return dw_negate_w(x); }
FN realw narrow_w(wide_w x) { return x.hi; }
FN wide_w wide_root_w(wide_w x) { return dw_sqrt_w(x); }
FN wide_w wide_add_w(wide_w x, wide_w y) { return dw_add_w(x, y); }
FN wide_w wide_subtract_w(wide_w x, wide_w y) { return dw_add_w(x, dw_negate_w(y)); }
FN wide_w wide_multiply_w(wide_w x, wide_w y) { return dw_mul_w(x, y); }
FN wide_w wide_scale_w(wide_w x, realw y) { return dw_scale_w(x, y); }
FN wide_w wide_divide_w(wide_w x, wide_w y) { return dw_div_w(x, y); }
FN wide_w wide_difference_w(realw x, realw y) { return two_sum_w(x, -y); }
FN wide_w wide_product_w(realw x, realw y) { return two_prod_w(x, y); }
FN wide_w wide_of_dw_w(dw_w x) { return x; }
/// m ? x : y.
FN wide_w wide_sel_w(maskw m, wide_w x, wide_w y) { return dw_sel_w(m, x, y); }
FN realw wide_least_w(wide_w x, realw off) { return x.hi + (x.lo - off); }
FN realw wide_most_w(wide_w x, realw off) { return x.hi + (x.lo + off); }
#endif

typedef struct {
  wide_w x, y, z;
} wide3_w;

/// p - q, each component to a rounding.
FN wide3_w wide_difference3_w(real3w p, real3w q) {
  wide3_w f;
  f.x = wide_difference_w(p.x, q.x);
  f.y = wide_difference_w(p.y, q.y);
  f.z = wide_difference_w(p.z, q.z);
  return f;
}

/// f.v, within 3 roundings of the sum of absolute values.
FN wide_w wide_dot_w(wide3_w f, real3w v) {
  return wide_add_w(wide_add_w(wide_scale_w(f.x, v.x), wide_scale_w(f.y, v.y)), wide_scale_w(f.z, v.z));
}

/// f.g, as wide_dot_w.
FN wide_w wide_dot3_w(wide3_w f, wide3_w g) {
  return wide_add_w(wide_add_w(wide_multiply_w(f.x, g.x), wide_multiply_w(f.y, g.y)), wide_multiply_w(f.z, g.z));
}

/// a d - b c, within 2 roundings of the sum of absolute values.
FN wide_w wide_determinant_w(wide_w a, wide_w b, wide_w c, wide_w d) {
  return wide_subtract_w(wide_multiply_w(a, d), wide_multiply_w(b, c));
}

/// The least and the most that t may round to in the lanes of `is_known`, where it is off by `off` at most; a NaN in
/// the others. The least is no -0: exact decisions know none (shapes/exact/exact_t.h, which comes before).
INLINE_FN void wide_range_w(wide_w t, realw off, maskw is_known, PRIVATE realw* least, PRIVATE realw* most) {
  realw nothing = splat_w(exact_nothing()), zero = splat_w(R(0.0)), first = wide_least_w(t, off);
  *least = sel_w(is_known, sel_w(eq_w(first, zero), zero, first), nothing);
  *most = sel_w(is_known, wide_most_w(t, off), nothing);
}
