// SPDX-License-Identifier: MIT
// For devices that end the loops of work-items after so many turns in sum (HAS_LOOP_LIMIT): Mesa's llvmpipe counts down
// from 65,535, over all loops of the work-items that it runs in step, and from 0 on leaves every loop after one turn,
// without a word. What a work-item has computed is right as long as it still gets a second turn.
#ifndef STRAHL_CORE_WHOLE_LOOPS_H
#define STRAHL_CORE_WHOLE_LOOPS_H

#include "portable.h"

/// 1: the device has ended none of the loops so far. Takes three turns. Two of them, as a number that no compiler knows
/// beforehand: it would leave the loop out.
FN int loops_were_whole(void) {
  uint turns = get_global_size(0) > 0 ? 2u : 1u, made = 0u;
  for (uint i = 0u; i < turns; ++i) ++made;
  return made == 2u;
}

#endif
