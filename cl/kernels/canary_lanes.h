// SPDX-License-Identifier: MIT
// What a device's arithmetic does in LANES lanes: every operation that the tiers build on, over cases that come from a
// buffer so that no compiler folds them. One work-item, LANES cases. One width; no guard.
#include "lanes/lane_ops.h"
#include "lanes/double_word.h"
#include "kernels/canary_layout.h"

FN void canary_put_w(GLOBAL real* out, realw a) {
  real values[LANES];
  store_w(a, values);
  for (int lane = 0; lane < LANES; ++lane) out[lane] = values[lane];
}

/// W. Kahan's difference of products, a b - c d within 1.5 ulp.
FN realw canary_difference_of_products_w(realw a, realw b, realw c, realw d) {
  realw cd = c * d;
  realw error = fma_w(-c, d, cd);
  return fma_w(a, b, -cd) + error;
}

KERNEL LANE_HINT void canary_w(GLOBAL const real* in, GLOBAL real* out, int count) {
  int i = (int)get_global_id(0) * LANES;
  if (i >= count) return;
  in += i;
  out += i;
  realw a = load_w(in + CANARY_A * count), b = load_w(in + CANARY_B * count);
  realw c = load_w(in + CANARY_C * count), d = load_w(in + CANARY_D * count);
  canary_put_w(out + CANARY_SUM * count, a + b);
  canary_put_w(out + CANARY_SUM_ERROR * count, two_sum_w(a, b).lo);
  canary_put_w(out + CANARY_DIFFERENCE * count, a - b);
  canary_put_w(out + CANARY_PRODUCT * count, a * b);
  canary_put_w(out + CANARY_PRODUCT_ERROR * count, two_prod_w(a, b).lo);
  canary_put_w(out + CANARY_PRODUCT_PLUS * count, a * b + c);
  canary_put_w(out + CANARY_PRODUCTS_DIFFERENCE * count, a * b - c * d);
  canary_put_w(out + CANARY_DIFFERENCE_OF_PRODUCTS * count, canary_difference_of_products_w(a, b, c, d));
  canary_put_w(out + CANARY_QUOTIENT * count, a / b);
  canary_put_w(out + CANARY_ROOT * count, sqrt_w(a));
  canary_put_w(out + CANARY_FMA * count, fma_w(a, b, c));
  canary_put_w(out + CANARY_LARGER * count, max_w(a, b));
  canary_put_w(out + CANARY_SMALLER * count, min_w(a, b));
  canary_put_w(out + CANARY_ZERO_TIMES * count, a * splat_w(R(0.0)));
  canary_put_w(out + CANARY_ZERO_PLUS * count, a + splat_w(R(0.0)));

  uint less = bits_w(lt_w(a, b)), at_most = bits_w(le_w(a, b)), equal = bits_w(eq_w(a, b));
  for (int lane = 0; lane < LANES; ++lane) {
    real x = in[CANARY_A * count + lane], y = in[CANARY_B * count + lane];
    uint bit = (uint)lane;
    uint order = (less >> bit & 1u) | (at_most >> bit & 1u) << 1 | (equal >> bit & 1u) << 2;
    out[CANARY_ORDER * count + lane] = (real)order;
    out[CANARY_TRUNCATED * count + lane] = (real)(int)x;
    out[CANARY_FROM_UINT * count + lane] = (real)(uint)x;
    out[CANARY_BUILTIN_MIN * count + lane] = fmin(x, y);
    out[CANARY_BUILTIN_MAX * count + lane] = fmax(x, y);
  }
}
