// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstdint>
#include <cstring>

#include "cl/angle_tiers.h"

#define REAL_BITS 32
namespace f32 {
#include "portable.h"
// portable.h comes first: it defines what the dialect is written in.
#include "math/angle.h"
#define LANES 1
#include "lanes/lane_ops.h"
// It is written in them.
#include "math/sincos_lanes.h"
}  // namespace f32

namespace strahl::test {

float atan2_turns(float y, float x) { return f32::atan2_turns(y, x); }
void sincos_turns(float turns, float* sine, float* cosine) {
  const f32::SinCos_w_1 turned = f32::sincos_turns_w_1(turns);
  *sine = turned.sine;
  *cosine = turned.cosine;
}

}  // namespace strahl::test
