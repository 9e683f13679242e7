// SPDX-License-Identifier: MIT
// What rays in lanes need besides lane_ops.h, which includes this. One width; no guard.
//
//   uintw                     lanes of 32 bits; + * ^ & | << >> among them and with a uint
//   splat_uint_w(x)           every lane x
//   sel_int_w(m, a, b)        m ? a : b of ids
//   lt_int_w lt_uint_w        compare
//   none_w() first_lanes_w(n)  mask of no lane, of the first n lanes
//   lane_numbers_w()          0, 1, 2 ...
//   high_product_w(a, b)      the upper half of the product
//   real_of_uint_w(a) real_of_int_w(a)  rounded
//   int_of_real_w(x)          towards 0
//   uint_of_int_w int_of_uint_w  the same bits
//   gather_w gather_int_w(p, i)  p[i], a place for each lane
//   gather_row_w(p, i, n, row)  p[i] to p[i + n - 1], a place for each lane; n: 4 at least
//   read_w read_int_w         LANES consecutive values of private memory
//   store_int_w               the other way
//   put_w put_int_w(p, i, x)  into lane i
//   get_w get_int_w(p, i)     of lane i
//   next_alike_w(i, m, ...)   the next lanes of m that are equal, in a loop over values
//   sum_int_w(a)              of all lanes
//   least_w(a) largest_w(a)   of all lanes; none may be NaN

#if LANES == 1
typedef uint uintw;
#define splat_uint_w_1(x) (x)
#define sel_int_w_1(m, a, b) select(b, a, m)
FN maskw lt_int_w(intw a, intw b) { return -(int)(a < b); }
FN maskw lt_uint_w(uintw a, uintw b) { return -(int)(a < b); }
FN uintw lane_numbers_w(void) { return 0u; }
FN uintw high_product_w(uintw a, uintw b) { return high_product(a, b); }
FN realw real_of_uint_w(uintw a) { return (real)a; }
FN realw real_of_int_w(intw a) { return (real)a; }
FN intw int_of_real_w(realw x) { return (int)x; }
FN uintw uint_of_int_w(intw a) { return (uint)a; }
FN intw int_of_uint_w(uintw a) { return (int)a; }
FN realw gather_w(GLOBAL const real* p, intw i) { return p[i]; }
FN intw gather_int_w(GLOBAL const int* p, intw i) { return p[i]; }
FN realw read_w(PRIVATE const real* p) { return *p; }
FN intw read_int_w(PRIVATE const int* p) { return *p; }
FN void store_int_w(intw a, PRIVATE int* p) { *p = a; }
FN real least_w(realw a) { return a; }
FN int sum_int_w(intw a) { return a; }
#else
#if ON_HOST
typedef uint uintw __attribute__((vector_size(LANES * sizeof(uint))));
FN uintw splat_uint_w(uint x) { return x - uintw{}; }
FN intw sel_int_w(maskw m, intw a, intw b) { return __builtin_convertvector(m, intw) ? a : b; }
FN maskw lt_int_w(intw a, intw b) { return __builtin_convertvector(a < b, maskw); }
FN maskw lt_uint_w(uintw a, uintw b) { return __builtin_convertvector(a < b, maskw); }
FN uintw lane_numbers_w(void) {
  uintw numbers;
  for (uint i = 0; i < LANES; ++i) numbers[i] = i;
  return numbers;
}
FN uintw high_product_w(uintw a, uintw b) {
  for (int i = 0; i < LANES; ++i) a[i] = high_product(a[i], b[i]);
  return a;
}
FN realw real_of_uint_w(uintw a) { return __builtin_convertvector(a, realw); }
FN realw real_of_int_w(intw a) { return __builtin_convertvector(a, realw); }
FN intw int_of_real_w(realw x) { return __builtin_convertvector(x, intw); }
FN uintw uint_of_int_w(intw a) { return (uintw)a; }
FN intw int_of_uint_w(uintw a) { return (intw)a; }
FN realw read_w(const real* p) { return load_w(p); }
FN intw read_int_w(const int* p) { return load_int_w(p); }
FN void store_int_w(intw a, int* p) { std::memcpy(p, &a, sizeof a); }
FN int sum_int_w(intw a) {
  int sum = 0;
  for (int i = 0; i < LANES; ++i) sum += a[i];
  return sum;
}
FN real least_w(realw a) {
  real least = a[0];
  for (int i = 1; i < LANES; ++i) least = a[i] < least ? a[i] : least;
  return least;
}
#else
typedef LANE_VECTOR(uint) uintw;
FN uintw splat_uint_w(uint x) { return (uintw)(x); }
#if REAL_BITS == 64
FN intw sel_int_w(maskw m, intw a, intw b) { return LANE_VECTOR(convert_int)(m) ? a : b; }
FN realw real_of_uint_w(uintw a) { return LANE_VECTOR(convert_double)(a); }
FN realw real_of_int_w(intw a) { return LANE_VECTOR(convert_double)(a); }
#else
FN intw sel_int_w(maskw m, intw a, intw b) { return m ? a : b; }
FN realw real_of_uint_w(uintw a) { return LANE_VECTOR(convert_float)(a); }
FN realw real_of_int_w(intw a) { return LANE_VECTOR(convert_float)(a); }
#endif
FN intw int_of_real_w(realw x) { return LANE_VECTOR(convert_int)(x); }
FN maskw lt_int_w(intw a, intw b) { return LANE_TO_MASK(a < b); }
FN maskw lt_uint_w(uintw a, uintw b) { return LANE_TO_MASK(a < b); }
#if LANES == 16
FN uintw lane_numbers_w(void) { return (uintw)(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15); }
#else
FN uintw lane_numbers_w(void) { return (uintw)(0, 1, 2, 3, 4, 5, 6, 7); }
#endif
FN uintw high_product_w(uintw a, uintw b) { return mul_hi(a, b); }
FN uintw uint_of_int_w(intw a) { return LANE_VECTOR(as_uint)(a); }
FN intw int_of_uint_w(uintw a) { return LANE_VECTOR(as_int)(a); }
#ifdef __clang__
// As store_w.
FN realw read_w(PRIVATE const real* p) { return *(PRIVATE const RealsAnywhere_w*)p; }
FN intw read_int_w(PRIVATE const int* p) { return *(PRIVATE const IntsAnywhere_w*)p; }
FN void store_int_w(intw a, PRIVATE int* p) { *(PRIVATE IntsAnywhere_w*)p = a; }
#else
FN realw read_w(PRIVATE const real* p) { return LANE_VECTOR(vload)(0, p); }
FN intw read_int_w(PRIVATE const int* p) { return LANE_VECTOR(vload)(0, p); }
FN void store_int_w(intw a, PRIVATE int* p) { LANE_VECTOR(vstore)(a, 0, p); }
#endif
#if REAL_BITS == 64
FN real least_of_8_w(double8 a) {
  double4 b = a.lo < a.hi ? a.lo : a.hi;
  double2 c = b.lo < b.hi ? b.lo : b.hi;
  return c.x < c.y ? c.x : c.y;
}
#else
FN real least_of_8_w(float8 a) {
  float4 b = a.lo < a.hi ? a.lo : a.hi;
  float2 c = b.lo < b.hi ? b.lo : b.hi;
  return c.x < c.y ? c.x : c.y;
}
#endif
FN int sum_of_8_w(int8 a) {
  int4 b = a.lo + a.hi;
  int2 c = b.lo + b.hi;
  return c.x + c.y;
}
#if LANES == 16
FN real least_w(realw a) { return least_of_8_w(a.lo < a.hi ? a.lo : a.hi); }
FN int sum_int_w(intw a) { return sum_of_8_w(a.lo + a.hi); }
#else
FN real least_w(realw a) { return least_of_8_w(a); }
FN int sum_int_w(intw a) { return sum_of_8_w(a); }
#endif
#endif
#include "lanes/lane_gather.h"
#endif
#include "lanes/lane_rows.h"

FN maskw first_lanes_w(int n) { return lt_int_w(int_of_uint_w(lane_numbers_w()), splat_int_w(n)); }
FN maskw none_w(void) { return lt_w(splat_w(R(0.0)), splat_w(R(0.0))); }
FN void put_w(PRIVATE realw* p, int i, real x) { ((PRIVATE real*)p)[i] = x; }
FN void put_int_w(PRIVATE intw* p, int i, int x) { ((PRIVATE int*)p)[i] = x; }
FN real get_w(PRIVATE const realw* p, int i) { return ((PRIVATE const real*)p)[i]; }
FN int get_int_w(PRIVATE const intw* p, int i) { return ((PRIVATE const int*)p)[i]; }
/// Lanes of `which` whose value is that of the first of `lanes`; they are taken out of `lanes`. lanes: of `which`, at
/// least one. So a loop over values asks for all lanes of a value together. value: receives it.
FN maskw next_alike_w(intw values, maskw which, PRIVATE uint* lanes, PRIVATE int* value) {
  *value = get_int_w(&values, first_bit(*lanes));
  which = which & ~nonzero_w(values - splat_int_w(*value));
  *lanes &= ~bits_w(which);
  return which;
}
FN real largest_w(realw a) { return -least_w(-a); }
