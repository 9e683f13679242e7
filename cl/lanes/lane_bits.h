// SPDX-License-Identifier: MIT
// Compare mask to bit mask on the device, LANES 8 and 16. Runtimes built on clang (PoCL) offer builtins for the
// instructions of AVX-512 and AVX. Elsewhere each lane keeps its own bit and the halves are OR-ed, with the same
// result. The tests are nested because a compiler without __has_builtin must not see its argument.
#if REAL_BITS == 32 && LANES == 16 && defined(__has_builtin) && defined(__AVX512DQ__)
#if __has_builtin(__builtin_ia32_cvtd2mask512)
#define LANE_BITS_NATIVE(m) ((uint)__builtin_ia32_cvtd2mask512(m))
#endif
#endif
#if REAL_BITS == 32 && LANES == 8 && defined(__has_builtin) && defined(__AVX512DQ__) && defined(__AVX512VL__)
#if __has_builtin(__builtin_ia32_cvtd2mask256)
#define LANE_BITS_NATIVE(m) ((uint)(uchar)__builtin_ia32_cvtd2mask256(m))
#endif
#endif
#if REAL_BITS == 64 && LANES == 8 && defined(__has_builtin) && defined(__AVX512DQ__)
#if __has_builtin(__builtin_ia32_cvtq2mask512)
#define LANE_BITS_NATIVE(m) ((uint)(uchar)__builtin_ia32_cvtq2mask512(m))
#endif
#endif
#if !defined(LANE_BITS_NATIVE) && defined(__has_builtin) && defined(__AVX__)
#if __has_builtin(__builtin_ia32_movmskps256) && __has_builtin(__builtin_ia32_movmskpd256)
#if REAL_BITS == 32 && LANES == 8
#define LANE_BITS_NATIVE(m) ((uint)__builtin_ia32_movmskps256(as_float8(m)))
#elif REAL_BITS == 32
#define LANE_BITS_NATIVE(m) \
  ((uint)(__builtin_ia32_movmskps256(as_float8((m).lo)) | __builtin_ia32_movmskps256(as_float8((m).hi)) << 8))
#elif LANES == 8
#define LANE_BITS_NATIVE(m) \
  ((uint)(__builtin_ia32_movmskpd256(as_double4((m).lo)) | __builtin_ia32_movmskpd256(as_double4((m).hi)) << 4))
#endif
#endif
#endif

#ifdef LANE_BITS_NATIVE
FN uint bits_w(maskw m) { return LANE_BITS_NATIVE(m); }
#undef LANE_BITS_NATIVE
#elif LANES == 16
FN uint bits_w(maskw m) {
  maskw bit = m & (maskw)(1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024, 2048, 4096, 8192, 16384, 32768);
#if REAL_BITS == 64
  long8 b8 = bit.lo | bit.hi;
  long4 b4 = b8.lo | b8.hi;
#else
  int8 b8 = bit.lo | bit.hi;
  int4 b4 = b8.lo | b8.hi;
#endif
  return (uint)(b4.x | b4.y | b4.z | b4.w);
}
#else
FN uint bits_w(maskw m) {
  maskw bit = m & (maskw)(1, 2, 4, 8, 16, 32, 64, 128);
  return (uint)(bit.s0 | bit.s1 | bit.s2 | bit.s3 | bit.s4 | bit.s5 | bit.s6 | bit.s7);
}
#endif
