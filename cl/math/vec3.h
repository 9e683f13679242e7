// SPDX-License-Identifier: MIT
// Three reals in registers, and the few operations on them. No operator overloads (OpenCL C has none), no built-ins:
// dot, cross and normalize of the standard leave their rounding to the device. Sums run x, y, z by fma, one order for
// every device. Never stored in buffers: those hold plain reals.
#ifndef STRAHL_MATH_VEC3_H
#define STRAHL_MATH_VEC3_H

#include "portable.h"

typedef struct {
  real x, y, z;
} real3;

FN real3 vec3(real x, real y, real z) {
  real3 v;
  v.x = x;
  v.y = y;
  v.z = z;
  return v;
}

FN real3 load3(GLOBAL const real* p) { return vec3(p[0], p[1], p[2]); }
FN void store3(real3 v, GLOBAL real* p) {
  p[0] = v.x;
  p[1] = v.y;
  p[2] = v.z;
}

FN real3 add3(real3 a, real3 b) { return vec3(a.x + b.x, a.y + b.y, a.z + b.z); }
FN real3 sub3(real3 a, real3 b) { return vec3(a.x - b.x, a.y - b.y, a.z - b.z); }
FN real3 mul3(real3 a, real3 b) { return vec3(a.x * b.x, a.y * b.y, a.z * b.z); }
FN real3 scale3(real s, real3 a) { return vec3(s * a.x, s * a.y, s * a.z); }
FN real3 negate3(real3 a) { return vec3(-a.x, -a.y, -a.z); }

/// a + s b, one rounding a component.
FN real3 fma3(real s, real3 b, real3 a) {
  return vec3(real_fma(s, b.x, a.x), real_fma(s, b.y, a.y), real_fma(s, b.z, a.z));
}

FN real dot3(real3 a, real3 b) { return real_fma(a.z, b.z, real_fma(a.y, b.y, a.x * b.x)); }

/// a b - c d with an error of at most 1.5 ulp, so its sign is right barring underflow.
/// Jeannerod, Louvet, Muller, "Further analysis of Kahan's algorithm ...", Math. Comp. 82, 2013.
FN real difference_of_products(real a, real b, real c, real d) {
  real cd = c * d;
  real error = real_fma(-c, d, cd);
  return real_fma(a, b, -cd) + error;
}

/// The rounding error of s = a - b. Knuth, The Art of Computer Programming, vol. 2, 1997, section 4.2.2.
FN real difference_rest(real a, real b, real s) {
  real minus_b = s - a;
  return (a - (s - minus_b)) - (b + minus_b);
}

FN real3 cross3(real3 a, real3 b) {
  return vec3(difference_of_products(a.y, b.z, a.z, b.y), difference_of_products(a.z, b.x, a.x, b.z),
              difference_of_products(a.x, b.y, a.y, b.x));
}

FN real max3(real3 a) {
  real m = a.x;
  if (m < a.y) m = a.y;
  if (m < a.z) m = a.z;
  return m;
}

FN real3 abs3(real3 a) { return vec3(real_abs(a.x), real_abs(a.y), real_abs(a.z)); }

/// The power of two (exponent within the normal range) that brings m = max |v_i| into [1, 2), and its inverse.
/// 1 for zero, infinite and NaN values of m.
typedef struct {
  real up, down;
} PowerOfTwo;

FN PowerOfTwo power_of_two_to_one(real m) {
  PowerOfTwo p;
  int bias = REAL_EXPONENT_MASK >> 1;
  int exponent = (int)(real_to_bits(m) >> REAL_EXPONENT_SHIFT) & REAL_EXPONENT_MASK;
  if (exponent < 1) exponent = 1;
  if (exponent > 2 * bias - 1) exponent = 2 * bias - 1;
  p.up = bits_to_real((bitsr)(2 * bias - exponent) << REAL_EXPONENT_SHIFT);
  p.down = bits_to_real((bitsr)exponent << REAL_EXPONENT_SHIFT);
  if (!(m > R(0.0))) p.up = p.down = R(1.0);
  return p;
}

FN int is_finite3(real3 v) { return real_is_finite(v.x) & real_is_finite(v.y) & real_is_finite(v.z); }

/// v / |v|; components up to 2.5 ulp. Scaled first, so neither overflow nor underflow. Zero stays zero.
FN real3 normalize3(real3 v) {
  PowerOfTwo p = power_of_two_to_one(max3(abs3(v)));
  real3 w = scale3(p.up, v);
  real norm = real_sqrt(dot3(w, w));
  if (!(norm > R(0.0))) return w;
  return vec3(w.x / norm, w.y / norm, w.z / norm);
}

/// normalize3, the same bits, of a vector whose square neither overflows nor underflows: directions, ways within a
/// scene.
FN real3 unit3(real3 v) {
  real norm = real_sqrt(dot3(v, v));
  return vec3(v.x / norm, v.y / norm, v.z / norm);
}

FN real length3(real3 v) {
  PowerOfTwo p = power_of_two_to_one(max3(abs3(v)));
  real3 w = scale3(p.up, v);
  return real_sqrt(dot3(w, w)) * p.down;
}

#endif
