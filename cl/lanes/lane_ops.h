// SPDX-License-Identifier: MIT
// Lane types and operations for one value of LANES (1, 8 or 16): include once per width, after defining LANES.
// No include guard on purpose, except for one lane, which units include beside another width. Bodies use these, + - * /
// and unary - on realw, & | ~ on maskw, nothing else.
//
//   splat_w(x)                every lane x
//   lt_w le_w eq_w            compare, false on NaN
//   sel_w(m, a, b)            m ? a : b, no arithmetic
//   max_w(x, a) min_w(x, a)   the larger, smaller; a NaN x is dropped
//   fma_w sqrt_w              correctly rounded
//   difference_of_products_w(a, b, c, d)  a b - c d, as in math/vec3.h
//   abs_w(a)                  clears the sign
//   floor_w(a)                the largest integer not above a
//   nonzero_w(i)              mask of i != 0
//   finite_w(x) nan_w(x)      neither NaN nor infinite; NaN
//   power_of_two_w(x)         the largest power of two not above |x|, held within the exponents of normal numbers but
//                             the last; inverse_power_w(p): 1 / p, exact
//   power_of_half_w(n)        2^-n of ints, a normal number
//   halvings_w(p)             n of a power of two p = 2^-n, as a real
//   bits_w(m) any_w(m)        bit i = lane i; is a lane set
//   load_w load_int_w         LANES consecutive values
//   write_w write_int_w       the other way; store_w: into private memory
#include "lanes/lane_names.h"
#include "portable.h"

#if !(LANES == 1 && defined(STRAHL_LANE_OPS_1))
#if LANES == 1
#define STRAHL_LANE_OPS_1

typedef real realw;
typedef int intw;
typedef int maskw;

// Aliases, not functions: a compiler that does not optimise before it inlines (rusticl's) makes a variable of every
// parameter, and is slow with many variables (docs/decisions/0018-soft-fma.md).
#define splat_w_1(x) (x)
#define splat_int_w_1(x) (x)
#define sel_w_1(m, a, b) real_select(b, a, m)
#define fma_w_1 real_fma
#define abs_w_1 real_abs
#define floor_w_1 real_floor
FN maskw lt_w(realw a, realw b) { return -(int)(a < b); }
FN maskw le_w(realw a, realw b) { return -(int)(a <= b); }
FN maskw eq_w(realw a, realw b) { return -(int)(a == b); }
FN maskw nonzero_w(intw i) { return -(int)(i != 0); }
FN realw sqrt_w(realw a) { return real_sqrt(a); }
FN uint bits_w(maskw m) { return (uint)(m & 1); }
FN int any_w(maskw m) { return m != 0; }
FN realw load_w(GLOBAL const real* p) { return *p; }
FN intw load_int_w(GLOBAL const int* p) { return *p; }
FN void store_w(realw a, PRIVATE real* p) { *p = a; }
FN void write_w(realw a, GLOBAL real* p) { *p = a; }
FN void write_int_w(intw a, GLOBAL int* p) { *p = a; }

#elif ON_HOST
#include "lanes/lane_host.h"
#else
#include "lanes/lane_device.h"
#endif

FN realw difference_of_products_w(realw a, realw b, realw c, realw d) {
  realw cd = c * d;
  return fma_w(a, b, -cd) + fma_w(-c, d, cd);
}

FN realw max_w(realw x, realw a) { return sel_w(lt_w(a, x), x, a); }
FN realw min_w(realw x, realw a) { return sel_w(lt_w(x, a), x, a); }

#include "lanes/lane_exponent.h"
#include "lanes/lane_access.h"
#endif
