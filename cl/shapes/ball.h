// SPDX-License-Identifier: MIT
// Bounding balls. Every kind of shape states its own, x_ball_w in shapes/x/x_lanes.h. Rays of a packet that miss the
// ball of a kind without a body are not tested against the shape (shapes/packet/packet_near_lanes.h). The ball holds
// every point of the shape; the test is tests/robust/test_balls.cpp.
#ifndef STRAHL_SHAPES_BALL_H
#define STRAHL_SHAPES_BALL_H

#include "math/vec3.h"

typedef struct {
  real3 centre;
  real radius;
} Ball;

/// The radius is enlarged by 2^-20 of itself, which covers the rounding of a few operations.
FN Ball ball_of(real3 centre, real radius) {
  Ball ball;
  ball.centre = centre;
  ball.radius = real_fma(R(0x1p-20), radius, radius);
  return ball;
}

/// The ball of an unbounded shape.
FN Ball ball_of_all(real3 centre) {
  Ball ball;
  ball.centre = centre;
  ball.radius = REAL_MAX;
  return ball;
}

/// Around the axis-aligned box lo ... hi. The middle is rounded, too.
FN Ball ball_around_box(real3 lo, real3 hi) {
  real3 across = sub3(hi, lo);
  return ball_of(fma3(R(0.5), across, lo),
                 real_fma(R(0x1p-20), max3(abs3(lo)) + max3(abs3(hi)), R(0.5) * length3(across)));
}

/// Around a polygon: the centre is its first corner, the radius the distance of the farthest other corner. There are at
/// least two others.
FN Ball ball_around_corners(real3 corner, real3 a, real3 b, real3 c) {
  real radius = length3(sub3(a, corner)), to_b = length3(sub3(b, corner)), to_c = length3(sub3(c, corner));
  if (radius < to_b) radius = to_b;
  if (radius < to_c) radius = to_c;
  return ball_of(corner, radius);
}

#endif
