// SPDX-License-Identifier: MIT
// From the unit square to discs, hemispheres, triangles and cones, area onto area, and the densities that come of it.
// + - * / fma sqrt only, angles as in math/angle.h. Held by tests/cl/test_sampling.cpp against closed forms.
#ifndef STRAHL_MATH_SAMPLING_H
#define STRAHL_MATH_SAMPLING_H

#include "math/angle.h"
#include "math/vec3.h"

#define ONE_OVER_PI R(0.318309886183790671538)

typedef struct {
  real x, y;
} real2;

/// Uniform on the unit disk, squares about the middle onto circles.
/// P. Shirley, K. Chiu, "A Low Distortion Map Between Disk and Square", Journal of Graphics Tools 2(3), 1997.
FN real2 square_to_disk(real u, real v) {
  real2 p;
  real a = real_fma(R(2.0), u, -R(1.0)), b = real_fma(R(2.0), v, -R(1.0));
  int is_wide = real_abs(a) > real_abs(b);
  real radius = is_wide ? a : b, across = is_wide ? b : a;
  real sine, cosine;
  sincos_eighth(radius != R(0.0) ? R(0.125) * (across / radius) : R(0.0), &sine, &cosine);
  p.x = radius * (is_wide ? cosine : sine);
  p.y = radius * (is_wide ? sine : cosine);
  return p;
}

/// Unit, z > 0, density z / pi: N. Malley's method, the disk's points lifted onto the hemisphere.
FN real3 square_to_cosine_hemisphere(real u, real v) {
  real2 p = square_to_disk(u, v);
  real rest = real_fma(-p.x, p.x, real_fma(-p.y, p.y, R(1.0)));
  // The corners of the square are the horizon, which has no density; rounding must not lead below it.
  real least = R(2.0) * real_roundoff();
  return vec3(p.x, p.y, real_sqrt(rest > least ? rest : least));
}

/// Unit, every direction alike: density 1 / (4 pi).
FN real3 square_to_sphere(real u, real v) {
  real z = real_fma(-R(2.0), u, R(1.0));
  real radius = R(2.0) * real_sqrt(u * (R(1.0) - u));
  real sine, cosine;
  sincos_turns(v, &sine, &cosine);
  return vec3(radius * cosine, radius * sine, z);
}

/// Weights of two of the corners, uniform over the triangle.
/// E. Heitz, "A Low-Distortion Map Between Triangle and Square", 2019.
FN real2 square_to_triangle(real u, real v) {
  real2 weights;
  real less = R(0.5) * (u < v ? u : v);
  weights.x = u < v ? less : u - less;
  weights.y = u < v ? v - less : less;
  return weights;
}

/// Two unit vectors that make a right-handed frame with the unit vector n. T. Duff and others, "Building an Orthonormal
/// Basis, Revisited", JCGT 6(1), 2017.
FN void frame_around(real3 n, real3* x, real3* y) {
  real one = R(1.0);
  real sign = n.z < R(0.0) ? -one : one;
  real a = -one / (sign + n.z);
  real b = n.x * n.y * a;
  *x = vec3(real_fma(sign * n.x * n.x, a, one), sign * b, -sign * n.x);
  *y = vec3(b, real_fma(n.y * n.y, a, sign), -n.y);
}

/// x a.x + y a.y + z a.z
FN real3 from_frame(real3 x, real3 y, real3 z, real3 a) { return fma3(a.z, z, fma3(a.y, y, scale3(a.x, x))); }

#endif
