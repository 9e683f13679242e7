// SPDX-License-Identifier: MIT
// cl/math/angle.h and sincos_lanes.h of both tiers side by side; each is compiled in a unit of its own (angle_f32.cpp,
// angle_f64.cpp).
#pragma once

namespace strahl::test {

float atan2_turns(float y, float x);
double atan2_turns(double y, double x);
void sincos_turns(float turns, float* sine, float* cosine);
void sincos_turns(double turns, double* sine, double* cosine);

}  // namespace strahl::test
