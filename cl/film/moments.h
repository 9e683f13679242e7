// SPDX-License-Identifier: MIT
// Second moments: the mean of the squares of a pixel's samples, in CIE 1931's X, Y and Z, as Mitsuba's integrator
// moment has them. Their sum stands behind the pixel's sub-sums.
#ifndef STRAHL_FILM_MOMENTS_H
#define STRAHL_FILM_MOMENTS_H

#include "film/film.h"
#include "film/xyz.h"
#include "math/vec3.h"

/// Adds `times` equal squares. What is not finite was counted with the samples themselves.
FN void add_squared(const Scene* scene, GLOBAL long* sum, real3 squares, int times) {
  film_add_color_slowly(scene, sum, vec3(film_held(squares.x), film_held(squares.y), film_held(squares.z)), times);
}

/// Adds `times` equal samples.
SELDOM_FN void add_squares(const Scene* scene, GLOBAL long* sum, real3 light, int times) {
  real x = dot3(vec3(XYZ_OF_RGB_X), light), y = dot3(vec3(XYZ_OF_RGB_Y), light), z = dot3(vec3(XYZ_OF_RGB_Z), light);
  add_squared(scene, sum, vec3(x * x, y * y, z * z), times);
}

#endif
