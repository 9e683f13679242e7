// SPDX-License-Identifier: MIT
// One ray in, one hit out: what `strahl intersect` computes per work-item and what the host repeats bit for bit.
// One width; no guard.
#include "accel/flat.h"
#include "shapes/shape.h"

/// in: RAY_REALS reals. out, ids: HIT_REALS reals and HIT_INTS ints; a miss is infinite, -1, -1 and zeros.
FN void LANED(trace_one)(const Scene* scene, GLOBAL const real* in, int left, int any_only, GLOBAL real* out,
                         GLOBAL int* ids) {
  Ray ray = ray_make(load3(in + RAY_O), load3(in + RAY_D), in[RAY_T_MIN], in[RAY_T_MAX], left);
  real infinite = bits_to_real((bitsr)REAL_EXPONENT_MASK << REAL_EXPONENT_SHIFT);
  for (int i = 0; i < HIT_REALS; ++i) out[i] = R(0.0);
  out[HIT_T] = infinite;
  ids[HIT_SHAPE] = -1;
  ids[HIT_PRIMITIVE] = -1;
  if (any_only) {
    if (LANED(any_hit)(scene, &ray)) out[HIT_T] = R(0.0);
    return;
  }
  Nearest hit = LANED(closest_hit)(scene, &ray);
  if (hit.kind < 0) return;
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
