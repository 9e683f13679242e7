// SPDX-License-Identifier: MIT
// The sign of a sum of products of real numbers, without any rounding: a fixed-point accumulator as wide as the
// exponents of all products (U. Kulisch, W. Miranker, "The Arithmetic of the Digital Computer: A New Approach", SIAM
// Review 28(1), 1986). Integers only, so no underflow, no overflow, and the same answer on every device. Single
// precision, one lane.
#ifndef STRAHL_SHAPES_EXACT_SUM_H
#define STRAHL_SHAPES_EXACT_SUM_H

#include "math/vec3.h"
#include "portable.h"

/// (-1)^negative (d0 + d1 2^32 + d2 2^64) 2^place: a product of up to three numbers of 25 bits and fewer.
typedef struct {
  uint d0, d1, d2, negative;
  int place;
} ExactNumber;

/// A sum of exact numbers.
typedef struct {
  ExactNumber of[6];
  int count;
} ExactFactor;

/// The lowest bit of a product of four reals and two midpoints is 2^-896 or higher, its highest below 2^776. Digits of
/// 32 bits; the halves above them take up what 2^24 terms carry.
enum { EXACT_LOWEST = -896, EXACT_DIGITS = 58 };

typedef struct {
  long digits[EXACT_DIGITS];
} ExactSum;

FN ExactNumber exact_number(real x) {
  uint bits = real_to_bits(x);
  int field = (int)(bits >> 23 & 255u);
  ExactNumber n;
  n.d0 = (bits & 0x7fffffu) | (uint)min(field, 1) << 23;
  n.d1 = n.d2 = 0u;
  n.negative = bits >> 31;
  n.place = max(field, 1) - 150;
  return n;
}

INLINE_FN ExactNumber exact_negated(ExactNumber n) {
  n.negative ^= 1u;
  return n;
}

/// n x, of at most 72 bits.
INLINE_FN ExactNumber exact_times(ExactNumber n, real x) {
  ExactNumber by = exact_number(x);
  ulong low = (ulong)n.d0 * by.d0, middle = (ulong)n.d1 * by.d0 + (low >> 32);
  n.d2 = n.d2 * by.d0 + (uint)(middle >> 32);
  n.d1 = (uint)middle;
  n.d0 = (uint)low;
  n.negative ^= by.negative;
  n.place += by.place;
  return n;
}

FN void exact_clear(PRIVATE ExactSum* sum) {
  for (int i = 0; i < EXACT_DIGITS; ++i) sum->digits[i] = 0;
}

/// sum + x y.
FN void exact_add(PRIVATE ExactSum* sum, ExactNumber x, ExactNumber y) {
  uint a[3], b[3], product[7];
  a[0] = x.d0;
  a[1] = x.d1;
  a[2] = x.d2;
  b[0] = y.d0;
  b[1] = y.d1;
  b[2] = y.d2;
  for (int i = 0; i < 7; ++i) product[i] = 0u;
  for (int i = 0; i < 3; ++i) {
    ulong carry = 0;
    for (int k = 0; k < 3; ++k) {
      carry += (ulong)a[i] * b[k] + product[i + k];
      product[i + k] = (uint)carry;
      carry >>= 32;
    }
    product[i + 3] = (uint)carry;
  }
  int at = x.place + y.place - EXACT_LOWEST, first = at >> 5, shift = at & 31;
  uint below = 0u, differ = x.negative ^ y.negative;
  for (int i = 0; i < 7; ++i) {
    long digit = (long)(((ulong)product[i] << 32 | below) << shift >> 32);
    sum->digits[first + i] += (digit ^ -(long)differ) + (long)differ;
    below = product[i];
  }
}

/// sum + x y; negative: sum - x y.
FN void exact_add_product(PRIVATE ExactSum* sum, PRIVATE const ExactFactor* x, PRIVATE const ExactFactor* y,
                          uint negative) {
  for (int i = 0; i < x->count; ++i)
    for (int k = 0; k < y->count; ++k) {
      ExactNumber one = x->of[i];
      one.negative ^= negative;
      exact_add(sum, one, y->of[k]);
    }
}

/// -1, 0 or 1.
FN int exact_sign(PRIVATE const ExactSum* sum) {
  long carry = 0, some = 0;
  for (int i = 0; i < EXACT_DIGITS; ++i) {
    long digit = sum->digits[i] + carry;
    some |= digit & 0xffffffffL;
    carry = digit >> 32;
  }
  return carry < 0 ? -1 : (int)((some | carry) != 0);
}

#endif
