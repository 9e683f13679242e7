// SPDX-License-Identifier: MIT
// One ray in, one hit out: what `strahl intersect` computes per work-item and what the host repeats bit for bit.
// One width; no guard.
#include "accel/traverse.h"
#include "shapes/shape.h"

/// in: RAY_REALS reals; left: the id just left, -1: none.
FN Ray LANED(given_ray)(GLOBAL const real* in, int left) {
  return ray_make(load3(in + RAY_O), load3(in + RAY_D), in[RAY_T_MIN], in[RAY_T_MAX], left);
}

/// found: FOUND_INTS ints, t: one real of no meaning where nothing is hit.
FN void LANED(find_one)(const Scene* scene, GLOBAL const real* in, int left, GLOBAL real* t, GLOBAL int* found) {
  Ray ray = LANED(given_ray)(in, left);
  Nearest hit = LANED(closest_hit)(scene, &ray);
  *t = hit.t;
  found[FOUND_ID] = hit.id;
  found[FOUND_KIND] = hit.kind;
  found[FOUND_SLOT] = hit.slot;
}

/// Is anything hit: 1 or 0.
FN int LANED(is_any_hit)(const Scene* scene, GLOBAL const real* in, int left) {
  Ray ray = LANED(given_ray)(in, left);
  return LANED(any_hit)(scene, &ray);
}

/// out, ids: HIT_REALS reals and HIT_INTS ints of what find_one has found; a miss is infinite, -1, -1 and zeros.
FN void LANED(describe_one)(const Scene* scene, GLOBAL const real* in, int left, real t, GLOBAL const int* found,
                            GLOBAL real* out, GLOBAL int* ids) {
  for (int i = 0; i < HIT_REALS; ++i) out[i] = R(0.0);
  out[HIT_T] = bits_to_real((bitsr)REAL_EXPONENT_MASK << REAL_EXPONENT_SHIFT);
  ids[HIT_SHAPE] = -1;
  ids[HIT_PRIMITIVE] = -1;
  Nearest hit;
  hit.t = t;
  hit.id = found[FOUND_ID];
  hit.kind = found[FOUND_KIND];
  hit.slot = found[FOUND_SLOT];
  if (hit.kind < 0) return;
  Ray ray = LANED(given_ray)(in, left);
  Surface s = surface_at(scene, &ray, &hit, LANES);
  out[HIT_T] = ray_given_t(&ray, hit.t, in[RAY_T_MIN], in[RAY_T_MAX]);
  out[HIT_U] = s.u;
  out[HIT_V] = s.v;
  out[HIT_NORMAL] = s.normal.x;
  out[HIT_NORMAL + 1] = s.normal.y;
  out[HIT_NORMAL + 2] = s.normal.z;
  ids[HIT_SHAPE] = s.shape;
  ids[HIT_PRIMITIVE] = s.primitive;
}
