// SPDX-License-Identifier: MIT
// What a device's arithmetic does, in LANES lanes and in one, and whether loops end where they should. The host, whose
// arithmetic is IEEE 754, compares the results (src/trust/canary.h). One program, since each program costs PoCL time by
// itself (docs/decisions/0017-once.md).
#include "math/vec3.h"
#include "kernels/whole_loops.h"
#include "kernels/canary_lanes.h"

/// 0: LANES lanes only.
#ifndef CANARY_ONE_LANE
#define CANARY_ONE_LANE 1
#endif
#if LANES != 1 && CANARY_ONE_LANE
#undef LANES
#define LANES 1
#include "kernels/canary_lanes.h"
#endif

/// Work-item i: turns[2 i] turns around turns[2 i + 1] inner ones. Each turn advances a generator of full period by one
/// step (D. Knuth, "The Art of Computer Programming", vol. 2, 1997, 3.3.4), so that its state, state[2 i], shows how
/// many turns were made. state[2 i + 1]: whether the work-item itself finds that all turns were made.
KERNEL void canary_loops(GLOBAL const uint* turns, GLOBAL uint* state) {
  int i = (int)get_global_id(0);
  uint x = 0u;
  for (uint outer = 0u; outer < turns[2 * i]; ++outer) {
    x = x * 1664525u + 1013904223u;
    for (uint inner = 0u; inner < turns[2 * i + 1]; ++inner) x = x * 1664525u + 1013904223u;
  }
  state[2 * i] = x;
  state[2 * i + 1] = (uint)loops_were_whole();
}
