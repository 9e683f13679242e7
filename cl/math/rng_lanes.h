// SPDX-License-Identifier: MIT
// Random numbers that depend on nothing but pixel, sample, dimension and seed, so a picture does not depend on how its
// samples were split into launches or devices. Method: pcg4d, M. Jarzynski, M. Olano, "Hash Functions for GPU
// Rendering", JCGT 9(3), 2020. One width; no guard.

typedef struct {
  uintw x, y, z, w;
} Random4_w;

FN Random4_w random4_w(uintw pixel, uintw sample, uintw dimension, uint seed) {
  Random4_w v;
  v.x = pixel * 1664525u + 1013904223u;
  v.y = sample * 1664525u + 1013904223u;
  v.z = dimension * 1664525u + 1013904223u;
  v.w = splat_uint_w(seed * 1664525u + 1013904223u);
  v.x += v.y * v.w;
  v.y += v.z * v.x;
  v.z += v.x * v.y;
  v.w += v.y * v.z;
  v.x ^= v.x >> 16;
  v.y ^= v.y >> 16;
  v.z ^= v.z >> 16;
  v.w ^= v.w >> 16;
  v.x += v.y * v.w;
  v.y += v.z * v.x;
  v.z += v.x * v.y;
  v.w += v.y * v.z;
  return v;
}

/// [0, 1), never 1: 24 bits in fp32 and 32 in fp64 are exact.
FN realw random_unit_w(uintw bits) {
#if REAL_BITS == 64
  return real_of_uint_w(bits) * splat_w(R(0x1p-32));
#else
  return real_of_uint_w(bits >> 8) * splat_w(R(0x1p-24));
#endif
}

/// (0, 1), neither end, symmetrically about the middle.
FN realw random_between_w(uintw bits) {
#if REAL_BITS == 64
  return (real_of_uint_w(bits) + splat_w(R(0.5))) * splat_w(R(0x1p-32));
#else
  return (real_of_uint_w(bits >> 9) + splat_w(R(0.5))) * splat_w(R(0x1p-23));
#endif
}
