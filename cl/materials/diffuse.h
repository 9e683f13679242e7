// SPDX-License-Identifier: MIT
// Lambertian reflection, f = rho / pi. Parameters: rho r g b.
#ifndef STRAHL_MATERIALS_DIFFUSE_H
#define STRAHL_MATERIALS_DIFFUSE_H

#include "math/vec3.h"

/// f times the cosine at the light; cos_i, cos_o > 0 are the cosines with the shading normal.
FN real3 diffuse_eval(GLOBAL const real* params, real cos_i, real cos_o) {
  (void)cos_o;
  return scale3(cos_i * R(0.318309886183790671538), load3(params));
}

#endif
