// SPDX-License-Identifier: MIT
// Lambertian reflection, f = rho / pi. Parameters: rho r g b.
#ifndef STRAHL_MATERIALS_DIFFUSE_H
#define STRAHL_MATERIALS_DIFFUSE_H

#include "math/vec3.h"

FN real3 diffuse_eval(real3 reflectance, real cos_i, real cos_o) {
  (void)cos_o;
  return scale3(cos_i * R(0.318309886183790671538), reflectance);
}

FN real3 diffuse_mirror(real3 reflectance) {
  (void)reflectance;
  return vec3(R(0.0), R(0.0), R(0.0));
}

#endif
