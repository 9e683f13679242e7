// SPDX-License-Identifier: MIT
// The base of the dialect: everything in which OpenCL C 1.2 and C++20 differ. The only file that asks which language it
// is.
//
// Needs REAL_BITS (32 or 64): the precision tier's floating type. On the host, include <cmath>, <cstdint> and <cstring>
// first, then this inside a namespace of the tier (f32 or f64): one translation unit holds one tier.
// Rules of the dialect: cl/README.md.
#ifndef STRAHL_PORTABLE_H
#define STRAHL_PORTABLE_H

/// 1: single precision, exact or compensated (docs/decisions/0007-robust-tier.md). The program's text defines it.
#ifndef TIER_ROBUST
#define TIER_ROBUST 0
#endif

/// 1: the textbook's formulas in the files named *_fast*, with contraction and relaxed maths allowed. The other tiers
/// are compared with it. The program's text defines it; on the host only tests/physics has this tier.
#ifndef TIER_FAST
#define TIER_FAST 0
#endif

/// 1: the device has no fma of its own for single precision (CL_FP_FMA): math/soft_fma.h stands in. The program's text
/// defines it (src/opencl/program.cpp).
#ifndef SOFT_FMA
#define SOFT_FMA 0
#endif

/// 1: what the robust tier computes beyond single precision is in doubles, else in double words; the bits are the same
/// (docs/decisions/0023-correctly-rounded-t.md). The program's text defines it where the device has doubles.
#ifndef WIDE_IS_DOUBLE
#define WIDE_IS_DOUBLE 0
#endif
#if WIDE_IS_DOUBLE && !TIER_ROBUST
#undef WIDE_IS_DOUBLE
#define WIDE_IS_DOUBLE 0
#endif

#ifndef __cplusplus
#if TIER_FAST
#pragma OPENCL FP_CONTRACT ON
#else
#pragma OPENCL FP_CONTRACT OFF
#endif
// Where vectors are wider than the processor's registers clang warns of every function that takes one; here all are
// static, and PoCL prints the number of warnings to standard error. So does NVIDIA's driver of a warning that its clang
// does not know.
#ifdef __has_warning
#if __has_warning("-Wpsabi")
#pragma clang diagnostic ignored "-Wpsabi"
#endif
#endif
#endif

/// unused: a program holds only some of the callers. Tests compile this text on the host, where inlining all of it
/// would take minutes. So does Mesa: it inlines everything at last, but before that takes time by the square of the
/// program's variables, whose number grows with every copy (docs/decisions/0021-loop-limit.md). In the program that
/// holds everything each function has many callers: its compiler chooses (docs/decisions/0017-once.md).
///
/// INLINE_FN: functions that change a struct that they were given by value. Mesa 22.3 hands over the caller's own, so
/// that such a function, called as one, changes what the caller has (the same decision; tests/lint/changed_structs).
#ifdef __cplusplus
#define INLINE_FN static inline __attribute__((unused))
#define FN INLINE_FN
#else
#define INLINE_FN static inline __attribute__((always_inline, unused))
#if KEEPS_FUNCTIONS
#define FN static __attribute__((unused))
#else
#define FN INLINE_FN
#endif
#endif

/// As FN, for large functions that are seldom called: a program holds one copy, and callers pay for the call.
#define SELDOM_FN static __attribute__((noinline, unused))

/// As FN, for large functions of which a program holds one copy for all callers: above all the whole work of a kernel,
/// because PoCL compiles a kernel three times. Devices that run work-items in lanes have LANES 1 and inline it
/// (docs/decisions/0017-once.md).
#if defined(SCENE_LANES) && SCENE_LANES != 1
#define ONCE_FN SELDOM_FN
#else
#define ONCE_FN FN
#endif

/// Before a loop of constant length: its arrays become registers. Compilers that do not know it decide by themselves.
#if !defined(__cplusplus) && defined(__clang__)
#define UNROLLED _Pragma("unroll")
#else
#define UNROLLED
#endif

#ifdef __cplusplus
#define ON_HOST 1
#define GLOBAL
#define PRIVATE
typedef unsigned int uint;
typedef std::uint64_t ulong;
#if REAL_BITS == 64
typedef std::uint64_t bitsr;
#else
typedef std::uint32_t bitsr;
#endif
#else
#define ON_HOST 0
#define GLOBAL __global
#define PRIVATE __private
#define KERNEL __kernel
#if REAL_BITS == 64 || WIDE_IS_DOUBLE
#pragma OPENCL EXTENSION cl_khr_fp64 : enable
#endif
#if REAL_BITS == 64
typedef ulong bitsr;
#else
typedef uint bitsr;
#endif
#endif

#if REAL_BITS == 64
typedef double real;
#define R(x) x
#define REAL_MAX 0x1.fffffffffffffp+1023
#define REAL_EXPONENT_SHIFT 52
#define REAL_EXPONENT_MASK 0x7ff
#else
typedef float real;
#define R(x) x##f
#define REAL_MAX 0x1.fffffep+127f
#define REAL_EXPONENT_SHIFT 23
#define REAL_EXPONENT_MASK 0xff
#endif

/// Sums of planes and disks cancel more than any one precision holds: compensated in robust and in double.
#define TIER_COMPENSATED (TIER_ROBUST || REAL_BITS == 64)

#define INT_MAX_ID 0x7fffffff

#ifdef __cplusplus
FN bitsr real_to_bits(real x) {
  bitsr b;
  std::memcpy(&b, &x, sizeof b);
  return b;
}
FN real bits_to_real(bitsr b) {
  real x;
  std::memcpy(&x, &b, sizeof x);
  return x;
}
/// Position of the lowest set bit; m must not be 0.
FN int first_bit(uint m) { return __builtin_ctz(m); }
// As OpenCL C has them. What ?: chooses is a branch to compilers that do not optimise before they inline (rusticl's).
/// m must not be 0.
FN int clz(ulong m) { return __builtin_clzll(m); }
FN int min(int a, int b) { return a < b ? a : b; }
FN uint min(uint a, uint b) { return a < b ? a : b; }
FN int max(int a, int b) { return a < b ? b : a; }
FN int select(int otherwise, int then, int which) { return which ? then : otherwise; }
FN real select(real otherwise, real then, int which) { return which ? then : otherwise; }
#define real_select select
/// On the host one thread traces.
FN void add_atomically(GLOBAL uint* sum, uint number) { *sum += number; }
/// The upper half of the product.
FN uint high_product(uint a, uint b) { return (uint)((std::uint64_t)a * b >> 32); }
FN real real_fma(real a, real b, real c) { return std::fma(a, b, c); }
FN real real_sqrt(real a) { return std::sqrt(a); }
FN double wide_sqrt(double a) { return std::sqrt(a); }
FN real real_abs(real a) { return std::fabs(a); }
FN real real_floor(real a) { return std::floor(a); }
#else
#if REAL_BITS == 64
#define real_to_bits as_ulong
#define bits_to_real as_double
#else
#define real_to_bits as_uint
#define bits_to_real as_float
#endif
#if defined(__clang__) && defined(__BMI__)
// One instruction instead of three, in the inner loop of every traversal.
FN int first_bit(uint m) { return __builtin_ctz(m); }
#else
FN int first_bit(uint m) { return 31 - (int)clz(m & (~m + 1u)); }
#endif
FN void add_atomically(GLOBAL uint* sum, uint number) { atomic_add(sum, number); }
FN uint high_product(uint a, uint b) { return mul_hi(a, b); }
FN real real_sqrt(real a) { return sqrt(a); }
#if WIDE_IS_DOUBLE
FN double wide_sqrt(double a) { return sqrt(a); }
#endif
#define real_abs fabs
#define real_floor floor
#if REAL_BITS == 64
#define real_select(otherwise, then, which) select(otherwise, then, (long)(which))
#else
#define real_select select
#endif
#if SOFT_FMA && TIER_FAST
FN real real_fma(real a, real b, real c) { return a * b + c; }
#elif SOFT_FMA && REAL_BITS == 32
#include "math/soft_fma.h"
FN real real_fma(real a, real b, real c) { return soft_fma(a, b, c); }
#else
FN real real_fma(real a, real b, real c) { return fma(a, b, c); }
#endif
#endif

/// u: half the distance from 1 to the next larger number.
FN real real_roundoff(void) {
  return bits_to_real((bitsr)((REAL_EXPONENT_MASK >> 1) - REAL_EXPONENT_SHIFT - 1) << REAL_EXPONENT_SHIFT);
}

/// Neither NaN nor infinite. The bits decide, so that no compiler can assume the answer.
FN int real_is_finite(real x) {
  return ((int)(real_to_bits(x) >> REAL_EXPONENT_SHIFT) & REAL_EXPONENT_MASK) != REAL_EXPONENT_MASK;
}

/// 1: x is negative or -0.
FN int sign_bit(real x) { return (int)(real_to_bits(x) >> (REAL_BITS - 1)); }

#endif
