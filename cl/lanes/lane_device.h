// SPDX-License-Identifier: MIT
// LANES 8 and 16 on the device: OpenCL vectors. Included by lane_ops.h.
#define LANE_VECTOR(type) LANED_EXPAND_PLAIN(type, LANES)
#define LANED_EXPAND_PLAIN(type, lanes) LANED_PASTE_PLAIN(type, lanes)
#define LANED_PASTE_PLAIN(type, lanes) type##lanes

#if REAL_BITS == 64
typedef LANE_VECTOR(double) realw;
typedef LANE_VECTOR(long) maskw;
#define LANE_AS_MASK(a) LANE_VECTOR(as_long)(a)
#define LANE_AS_REAL(m) LANE_VECTOR(as_double)(m)
#define LANE_TO_MASK(i) LANE_VECTOR(convert_long)(i)
#define LANE_TO_INT(m) LANE_VECTOR(convert_int)(m)
#define LANE_TO_REAL(m) LANE_VECTOR(convert_double)(m)
#define LANE_SPLAT_MASK(x) ((maskw)((long)(x)))
#else
typedef LANE_VECTOR(float) realw;
typedef LANE_VECTOR(int) maskw;
#define LANE_AS_MASK(a) LANE_VECTOR(as_int)(a)
#define LANE_AS_REAL(m) LANE_VECTOR(as_float)(m)
#define LANE_TO_MASK(i) (i)
#define LANE_TO_INT(m) (m)
#define LANE_TO_REAL(m) LANE_VECTOR(convert_float)(m)
#define LANE_SPLAT_MASK(x) ((maskw)((int)(x)))
#endif
typedef LANE_VECTOR(int) intw;

FN realw splat_w(real x) { return (realw)(x); }
FN intw splat_int_w(int x) { return (intw)(x); }
FN maskw lt_w(realw a, realw b) { return a < b; }
FN maskw le_w(realw a, realw b) { return a <= b; }
FN maskw eq_w(realw a, realw b) { return a == b; }
FN realw sel_w(maskw m, realw a, realw b) { return m ? a : b; }
FN maskw nonzero_w(intw i) { return LANE_TO_MASK(i != splat_int_w(0)); }
FN realw fma_w(realw a, realw b, realw c) { return fma(a, b, c); }
FN realw sqrt_w(realw a) { return sqrt(a); }
FN realw abs_w(realw a) { return fabs(a); }
FN realw floor_w(realw a) { return floor(a); }
#ifdef __clang__
// A single access; vload and vstore of PoCL's library make four.
typedef realw RealsAnywhere_w __attribute__((aligned(sizeof(real))));
typedef intw IntsAnywhere_w __attribute__((aligned(sizeof(int))));
FN realw load_w(GLOBAL const real* p) { return *(GLOBAL const RealsAnywhere_w*)p; }
FN intw load_int_w(GLOBAL const int* p) { return *(GLOBAL const IntsAnywhere_w*)p; }
FN void store_w(realw a, PRIVATE real* p) { *(PRIVATE RealsAnywhere_w*)p = a; }
FN void write_w(realw a, GLOBAL real* p) { *(GLOBAL RealsAnywhere_w*)p = a; }
FN void write_int_w(intw a, GLOBAL int* p) { *(GLOBAL IntsAnywhere_w*)p = a; }
#else
FN realw load_w(GLOBAL const real* p) { return LANE_VECTOR(vload)(0, p); }
FN intw load_int_w(GLOBAL const int* p) { return LANE_VECTOR(vload)(0, p); }
FN void store_w(realw a, PRIVATE real* p) { LANE_VECTOR(vstore)(a, 0, p); }
FN void write_w(realw a, GLOBAL real* p) { LANE_VECTOR(vstore)(a, 0, p); }
FN void write_int_w(intw a, GLOBAL int* p) { LANE_VECTOR(vstore)(a, 0, p); }
#endif

#include "lanes/lane_bits.h"

FN int any_w(maskw m) { return bits_w(m) != 0u; }
