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
}  // namespace f64

namespace strahl::test {

double atan2_turns(double y, double x) { return f64::atan2_turns(y, x); }
void sincos_turns(double turns, double* sine, double* cosine) { f64::sincos_turns(turns, sine, cosine); }

}  // namespace strahl::test
