// SPDX-License-Identifier: MIT
// Second moments: the mean of the squares of a pixel's samples, in CIE 1931's X, Y and Z, as Mitsuba's integrator
// moment has them. Their sum stands behind the pixel's sub-sums.
#ifndef STRAHL_FILM_MOMENTS_H
#define STRAHL_FILM_MOMENTS_H

#include "film/film.h"
#include "film/xyz.h"
#include "math/vec3.h"

/// Adds `times` equal samples. What is not finite was counted with the samples themselves.
SELDOM_FN void add_squares(const Scene* scene, GLOBAL long* sum, real3 light, int times) {
  real x = dot3(vec3(XYZ_OF_RGB_X), light), y = dot3(vec3(XYZ_OF_RGB_Y), light), z = dot3(vec3(XYZ_OF_RGB_Z), light);
  film_add_color_slowly(scene, sum, vec3(film_held(x * x), film_held(y * y), film_held(z * z)), times);
}

#endif
