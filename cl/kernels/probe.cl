// SPDX-License-Identifier: MIT
// Single questions about one kind of shape, the only active one: work-item i intersects its ray with the blocks
// [block_first[i], block_first[i + 1]), whose ids count the question's primitives. t as hits/trace_one.h reports it.
// primitive: -1 for a miss, FOUND_CUT where the device has ended loops.
#include "math/vec3.h"
#include "lanes/lane_ops.h"
#include "accel/traverse.h"
#include "kernels/whole_loops.h"

KERNEL LANE_HINT void probe(GLOBAL const real* blocks, GLOBAL const int* block_ids, GLOBAL const int* block_first,
                            GLOBAL const real* rays, GLOBAL const int* departed, GLOBAL real* t, GLOBAL int* primitive,
                            int count) {
  int i = (int)get_global_id(0);
  if (i >= count) return;
  GLOBAL const real* in = rays + i * RAY_REALS;
  Ray ray = ray_make(load3(in + RAY_O), load3(in + RAY_D), in[RAY_T_MIN], in[RAY_T_MAX], departed[i]);
  Nearest best = nearest_none(ray.t_max);
  for (int b = block_first[i]; b < block_first[i + 1]; ++b) {
    GLOBAL const int* ids = block_ids + b * LANES;
    (void)ids;  // A program without shapes.
    (void)blocks;
#define SHAPE(name, planes) name##_block_w(&ray, blocks + b * (planes)*LANES, ids, b * LANES, &best);
#include "shapes/shapes.def"
#undef SHAPE
  }
#if TIER_ROBUST
  nearest_settle(&ray, &best, LANES);
#endif
  real infinite = bits_to_real((bitsr)REAL_EXPONENT_MASK << REAL_EXPONENT_SHIFT);
  t[i] = best.kind < 0 ? infinite : ray_given_t(&ray, best.t, in[RAY_T_MIN], in[RAY_T_MAX]);
  primitive[i] = best.kind < 0 ? -1 : best.id;
  if (!loops_were_whole()) primitive[i] = FOUND_CUT;
}
