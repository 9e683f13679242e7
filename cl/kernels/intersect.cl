// SPDX-License-Identifier: MIT
// N rays in, N hits out (core/trace_one.h), one work-item a ray: where they hit, or whether; then what is there.
#include "math/vec3.h"
#include "lanes/lane_ops.h"
#include "core/trace_one.h"

FN Scene scene_of(GLOBAL const real* geometry, GLOBAL const real* shading, GLOBAL const int* index) {
  Scene scene;
  scene.geometry = geometry;
  scene.shading = shading;
  scene.index = index;
  return scene;
}

KERNEL LANE_HINT void closest(GLOBAL const real* geometry, GLOBAL const real* shading, GLOBAL const int* index,
                              GLOBAL const real* rays, GLOBAL const int* left, GLOBAL real* t, GLOBAL int* found,
                              ulong count) {
  ulong i = get_global_id(0);
  if (i >= count) return;
  Scene scene = scene_of(geometry, shading, index);
  LANED(find_one)(&scene, rays + i * RAY_REALS, left[i], t + i, found + i * FOUND_INTS);
}

/// found: 1 or 0 a ray. t is not touched.
KERNEL LANE_HINT void anything(GLOBAL const real* geometry, GLOBAL const real* shading, GLOBAL const int* index,
                               GLOBAL const real* rays, GLOBAL const int* left, GLOBAL real* t, GLOBAL int* found,
                               ulong count) {
  ulong i = get_global_id(0);
  (void)t;
  if (i >= count) return;
  Scene scene = scene_of(geometry, shading, index);
  found[i] = LANED(is_any_hit)(&scene, rays + i * RAY_REALS, left[i]);
}

KERNEL LANE_HINT void describe(GLOBAL const real* geometry, GLOBAL const real* shading, GLOBAL const int* index,
                               GLOBAL const real* rays, GLOBAL const int* left, GLOBAL const real* t,
                               GLOBAL const int* found, GLOBAL real* hits, GLOBAL int* ids, ulong count) {
  ulong i = get_global_id(0);
  if (i >= count) return;
  Scene scene = scene_of(geometry, shading, index);
  LANED(describe_one)
  (&scene, rays + i * RAY_REALS, left[i], t[i], found + i * FOUND_INTS, hits + i * HIT_REALS, ids + i * HIT_INTS);
}
