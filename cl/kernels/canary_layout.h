// SPDX-License-Identifier: MIT
// Where canary.cl leaves its results, for kernel and host: plane after plane of one real a case.
#ifndef STRAHL_KERNELS_CANARY_LAYOUT_H
#define STRAHL_KERNELS_CANARY_LAYOUT_H

enum { CANARY_A, CANARY_B, CANARY_C, CANARY_D, CANARY_INPUTS };

enum {
  CANARY_SUM,
  CANARY_SUM_ERROR,  // TwoSum
  CANARY_DIFFERENCE,
  CANARY_PRODUCT,
  CANARY_PRODUCT_ERROR,           // TwoProd
  CANARY_PRODUCT_PLUS,            // a b + c, each rounded
  CANARY_PRODUCTS_DIFFERENCE,     // a b - c d, each rounded
  CANARY_DIFFERENCE_OF_PRODUCTS,  // a b - c d by Kahan
  CANARY_QUOTIENT,
  CANARY_ROOT,  // of a
  CANARY_FMA,   // of a, b, c
  CANARY_LARGER,
  CANARY_SMALLER,
  CANARY_ORDER,        // 1 where a < b, 2 where a <= b, 4 where a == b, added
  CANARY_TRUNCATED,    // of a, by way of int
  CANARY_FROM_UINT,    // of a, by way of uint
  CANARY_ZERO_TIMES,   // literal zero times a
  CANARY_ZERO_PLUS,    // literal zero plus a
  CANARY_BUILTIN_MIN,  // of a, b
  CANARY_BUILTIN_MAX,
  CANARY_OUTPUTS
};

#endif
