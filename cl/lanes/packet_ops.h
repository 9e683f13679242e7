// SPDX-License-Identifier: MIT
// What packets need of lanes besides lane_ops.h, LANES 8 and 16: include once per width; no guard.
//
//   sel_int_w(m, a, b)        m ? a : b of ids
//   lt_int_w(a, b)            compare ids
//   read_w read_int_w         LANES consecutive values of private memory
//   store_int_w               the other way
//   least_w(a) largest_w(a)   of all lanes; none may be NaN
#define sel_int_w LANED(sel_int_w)
#define lt_int_w LANED(lt_int_w)
#define read_w LANED(read_w)
#define read_int_w LANED(read_int_w)
#define store_int_w LANED(store_int_w)
#define least_w LANED(least_w)
#define largest_w LANED(largest_w)

#if ON_HOST
FN intw sel_int_w(maskw m, intw a, intw b) { return __builtin_convertvector(m, intw) ? a : b; }
FN maskw lt_int_w(intw a, intw b) { return __builtin_convertvector(a < b, maskw); }
FN realw read_w(const real* p) { return load_w(p); }
FN intw read_int_w(const int* p) { return load_int_w(p); }
FN void store_int_w(intw a, int* p) { std::memcpy(p, &a, sizeof a); }
FN real least_w(realw a) {
  real least = a[0];
  for (int i = 1; i < LANES; ++i) least = a[i] < least ? a[i] : least;
  return least;
}
#else
#if REAL_BITS == 64
FN intw sel_int_w(maskw m, intw a, intw b) { return LANE_VECTOR(convert_int)(m) ? a : b; }
#else
FN intw sel_int_w(maskw m, intw a, intw b) { return m ? a : b; }
#endif
FN maskw lt_int_w(intw a, intw b) { return LANE_TO_MASK(a < b); }
FN realw read_w(PRIVATE const real* p) { return LANE_VECTOR(vload)(0, p); }
FN intw read_int_w(PRIVATE const int* p) { return LANE_VECTOR(vload)(0, p); }
FN void store_int_w(intw a, PRIVATE int* p) { LANE_VECTOR(vstore)(a, 0, p); }
#if REAL_BITS == 64
FN real LANED(least_of_8)(double8 a) {
  double4 b = a.lo < a.hi ? a.lo : a.hi;
  double2 c = b.lo < b.hi ? b.lo : b.hi;
  return c.x < c.y ? c.x : c.y;
}
#else
FN real LANED(least_of_8)(float8 a) {
  float4 b = a.lo < a.hi ? a.lo : a.hi;
  float2 c = b.lo < b.hi ? b.lo : b.hi;
  return c.x < c.y ? c.x : c.y;
}
#endif
#if LANES == 16
FN real least_w(realw a) { return LANED(least_of_8)(a.lo < a.hi ? a.lo : a.hi); }
#else
FN real least_w(realw a) { return LANED(least_of_8)(a); }
#endif
#endif

FN real largest_w(realw a) { return -least_w(-a); }
