// SPDX-License-Identifier: MIT
// For devices that limit the total number of loop turns of a work-item (HAS_LOOP_LIMIT), as Mesa's llvmpipe does: when
// the limit is reached, every loop ends after one turn, without an error (docs/decisions/0021-loop-limit.md). The
// results of a work-item are right as long as a loop still makes a second turn.
#ifndef STRAHL_KERNELS_WHOLE_LOOPS_H
#define STRAHL_KERNELS_WHOLE_LOOPS_H

#include "portable.h"

/// 1: the device has ended none of the loops so far. The question costs three turns. The number two is unknown at
/// compile time, since a compiler would unroll a loop of constant length.
FN int loops_were_whole(void) {
#if ON_HOST
  return 1;
#else
  uint turns = get_global_size(0) > 0 ? 2u : 1u, made = 0u;
  for (uint i = 0u; i < turns; ++i) ++made;
  return made == 2u;
#endif
}

#endif
