// SPDX-License-Identifier: MIT
// Ideal mirror: the same share of the light at every angle. Parameters: specular reflectance r g b.
#ifndef STRAHL_MATERIALS_CONDUCTOR_H
#define STRAHL_MATERIALS_CONDUCTOR_H

#include "math/vec3.h"

/// No light from a point or a direction is reflected into any other direction but one.
FN real3 conductor_eval(real3 reflectance, real cos_i, real cos_o) {
  (void)reflectance;
  (void)cos_i;
  (void)cos_o;
  return vec3(R(0.0), R(0.0), R(0.0));
}

FN real3 conductor_mirror(real3 reflectance) { return reflectance; }

#endif
