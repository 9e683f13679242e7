// SPDX-License-Identifier: MIT
// What exact arithmetic says to a question, and whether the robust tier promises to say the same
// (docs/decisions/0007-robust-tier.md states the bands within which it does not).
#pragma once

#include "selftest/question.h"

namespace strahl::selftest {

struct ExactAnswer {
  bool hit = false;
  int primitive = -1;    ///< The nearest, the lowest index of equals.
  bool is_alone = true;  ///< No other is met within four ulps of float of it, so that rounding cannot swap the two.
  oracle::Exact t;
  bool is_promised = true;  ///< No primitive is within its band, and no crossing at the ends of the ray's range.
  double t_rounding = 0;    ///< As in Question; where a polygon is met within its band, what its edge may cost t.
};

/// Uses kind, planes, ray and left. A primitive that was left: a flat one is not met, a sphere or a cylinder at the
/// other root only, a box at its far side only. A ray that is not finite, or has no direction, meets nothing.
[[nodiscard]] ExactAnswer exact_answer(const Question&);

/// Writes the exact answer into the question: Expected::either where nothing is promised.
void answer(Question&);

}  // namespace strahl::selftest
