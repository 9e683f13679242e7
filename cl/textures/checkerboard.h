// SPDX-License-Identifier: MIT
// Two colours in squares of 1/2 by 1/2 of the mapped (u, v), four to a unit, as in Mitsuba's plugin.
// Parameters: colour 0, colour 1 (r g b each), then the map: u' = m0 u + m1 v + m2, v' = m3 u + m4 v + m5.
//
// Up to a footprint of half a square the value is that of the point. Beyond, it is the exact mean over a box of the
// footprint's size (A. Apodaca, L. Gritz, "Advanced RenderMan", 2000, ch. 11, do it with the integral of the wave as
// here). The footprint is at least the distance between neighbouring values of the coordinate. So where this distance
// approaches a square the mean is used, for any pixel size.
#ifndef STRAHL_TEXTURES_CHECKERBOARD_H
#define STRAHL_TEXTURES_CHECKERBOARD_H

#include "math/vec3.h"

/// Integral from 0 to x of the wave that is +1 on (0, 1/2], -1 on (1/2, 1]: it has period 1 and lies in [0, 1/2].
FN real checker_integral(real x) {
  real f = x - real_floor(x);
  return f > R(0.5) ? R(1.0) - f : f;
}

/// The wave at x, or its mean over a box of the given width around x.
FN real checker_wave(real x, real width) {
  real spacing = R(4.0) * real_roundoff() * real_abs(x);
  if (width < spacing) width = spacing;
  real zero = R(0.0);
  if (!real_is_finite(width) || !real_is_finite(x)) return zero;
  if (!(width > R(0.25))) return x - real_floor(x) > R(0.5) ? -R(1.0) : R(1.0);
  real half_width = R(0.5) * width;
  return (checker_integral(x + half_width) - checker_integral(x - half_width)) / width;
}

FN real3 checkerboard_value(GLOBAL const real* params, real u, real v, real du, real dv) {
  GLOBAL const real* m = params + 6;
  real x = real_fma(m[0], u, real_fma(m[1], v, m[2])), y = real_fma(m[3], u, real_fma(m[4], v, m[5]));
  real width_x = real_fma(real_abs(m[0]), du, real_abs(m[1]) * dv);
  real width_y = real_fma(real_abs(m[3]), du, real_abs(m[4]) * dv);
  // 1: all of colour 0. Weights before the sum, so that each colour comes out exactly.
  real share = real_fma(R(0.5) * checker_wave(x, width_x), checker_wave(y, width_y), R(0.5));
  return fma3(share, load3(params), scale3(R(1.0) - share, load3(params + 3)));
}

#endif
