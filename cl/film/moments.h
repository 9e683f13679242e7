// SPDX-License-Identifier: MIT
// Second moments: the mean of the squares of a pixel's samples, in CIE 1931's X, Y and Z, as Mitsuba's integrator
// moment has them. Their sum stands behind the pixel's sub-sums.
#ifndef STRAHL_FILM_MOMENTS_H
#define STRAHL_FILM_MOMENTS_H

#include "film/film.h"
#include "film/xyz.h"
#include "math/vec3.h"

/// A square as the film holds it. What is not finite was counted with the sample itself.
FN real moment_value(real square) {
  bitsr size = real_to_bits(square) & ~((bitsr)1 << (REAL_BITS - 1));
  if (size <= real_to_bits(FILM_LARGEST)) return square;
  return size <= (bitsr)REAL_EXPONENT_MASK << REAL_EXPONENT_SHIFT ? FILM_LARGEST : R(0.0);
}

/// Adds `times` equal samples.
SELDOM_FN void add_squares(const Scene* scene, GLOBAL long* sum, real3 light, int times) {
  real x = dot3(vec3(XYZ_OF_RGB_X), light), y = dot3(vec3(XYZ_OF_RGB_Y), light), z = dot3(vec3(XYZ_OF_RGB_Z), light);
  film_add_color_slowly(scene, sum, vec3(moment_value(x * x), moment_value(y * y), moment_value(z * z)), times);
}

#endif
