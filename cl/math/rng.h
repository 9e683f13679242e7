// SPDX-License-Identifier: MIT
// Counter-based random numbers: a pure function of (pixel, sample, dimension, seed), so a picture does not depend on
// how its samples were split into launches or devices.
// Method: pcg4d, M. Jarzynski, M. Olano, "Hash Functions for GPU Rendering", JCGT 9(3), 2020.
#ifndef STRAHL_MATH_RNG_H
#define STRAHL_MATH_RNG_H

#include "portable.h"

typedef struct {
  uint x, y, z, w;
} Random4;

FN Random4 random4(uint pixel, uint sample, uint dimension, uint seed) {
  Random4 v;
  v.x = pixel * 1664525u + 1013904223u;
  v.y = sample * 1664525u + 1013904223u;
  v.z = dimension * 1664525u + 1013904223u;
  v.w = seed * 1664525u + 1013904223u;
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
FN real random_unit(uint bits) {
#if REAL_BITS == 64
  return (real)bits * R(0x1p-32);
#else
  return (real)(bits >> 8) * R(0x1p-24);
#endif
}

/// (0, 1), neither end, symmetrically about the middle.
FN real random_between(uint bits) {
#if REAL_BITS == 64
  return ((real)bits + R(0.5)) * R(0x1p-32);
#else
  return ((real)(bits >> 9) + R(0.5)) * R(0x1p-23);
#endif
}

#endif
