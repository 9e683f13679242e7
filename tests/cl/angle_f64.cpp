// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstdint>
#include <cstring>

#include "cl/angle_tiers.h"

#define REAL_BITS 64
namespace f64 {
#include "portable.h"
// portable.h comes first: it defines what the dialect is written in.
#include "math/angle.h"
#define LANES 1
#include "lanes/lane_ops.h"
// It is written in them.
#include "math/sincos_lanes.h"
}  // namespace f64

namespace strahl::test {

double atan2_turns(double y, double x) { return f64::atan2_turns(y, x); }
void sincos_turns(double turns, double* sine, double* cosine) {
  const f64::SinCos_w_1 turned = f64::sincos_turns_w_1(turns);
  *sine = turned.sine;
  *cosine = turned.cosine;
}

}  // namespace strahl::test
