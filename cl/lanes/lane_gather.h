// SPDX-License-Identifier: MIT
// Gathers: each lane reads an address of its own, LANES 8 and 16. Runtimes built on clang for AVX-512 and AVX2 (PoCL)
// offer a builtin for the instruction. The tests are nested because a compiler without __has_builtin must not see its
// argument.
#if ON_HOST
FN realw gather_w(const real* p, intw i) {
  realw a;
  for (int k = 0; k < LANES; ++k) a[k] = p[i[k]];
  return a;
}
FN intw gather_int_w(const int* p, intw i) {
  intw a;
  for (int k = 0; k < LANES; ++k) a[k] = p[i[k]];
  return a;
}
#else
#if REAL_BITS == 32 && LANES == 16 && defined(__has_builtin) && defined(__AVX512F__)
#if __has_builtin(__builtin_ia32_gathersiv16sf) && __has_builtin(__builtin_ia32_gathersiv16si)
#define GATHER_ADDRESS(p) ((PRIVATE const void*)(ulong)(p))
FN realw gather_w(GLOBAL const real* p, intw i) {
  return __builtin_ia32_gathersiv16sf(splat_w(R(0.0)), GATHER_ADDRESS(p), i, (ushort)0xffff, 4);
}
FN intw gather_int_w(GLOBAL const int* p, intw i) {
  return __builtin_ia32_gathersiv16si(splat_int_w(0), GATHER_ADDRESS(p), i, (ushort)0xffff, 4);
}
#endif
#endif
#ifndef GATHER_ADDRESS
#define GATHER_8(p, i) \
  (p)[(i).s0], (p)[(i).s1], (p)[(i).s2], (p)[(i).s3], (p)[(i).s4], (p)[(i).s5], (p)[(i).s6], (p)[(i).s7]
#if LANES == 16
#define GATHER_ALL(p, i) GATHER_8(p, (i).lo), GATHER_8(p, (i).hi)
#else
#define GATHER_ALL(p, i) GATHER_8(p, i)
#endif
FN realw gather_w(GLOBAL const real* p, intw i) { return (realw)(GATHER_ALL(p, i)); }
FN intw gather_int_w(GLOBAL const int* p, intw i) { return (intw)(GATHER_ALL(p, i)); }
#undef GATHER_8
#undef GATHER_ALL
#endif
#undef GATHER_ADDRESS
#endif
