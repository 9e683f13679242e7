// SPDX-License-Identifier: MIT
// Ideal mirror: the same share of the light at every angle. Parameters: specular reflectance r g b.
#ifndef STRAHL_MATERIALS_CONDUCTOR_H
#define STRAHL_MATERIALS_CONDUCTOR_H

#include "materials/material_sample.h"

/// No light that was drawn is reflected into any other direction but one.
FN real3 conductor_eval(real3 reflectance, real3 wi, real3 wo) {
  (void)reflectance;
  (void)wi;
  (void)wo;
  return black3();
}

FN real conductor_density(real3 reflectance, real3 wi, real3 wo) {
  (void)reflectance;
  (void)wi;
  (void)wo;
  return R(0.0);
}

FN MaterialSample conductor_sample(real3 reflectance, real3 wo, real u, real v) {
  (void)u;
  (void)v;
  MaterialSample s;
  s.wi = vec3(-wo.x, -wo.y, wo.z);
  s.weight = wo.z > R(0.0) ? reflectance : black3();
  s.density = R(0.0);
  return s;
}

FN real3 conductor_mirror(real3 reflectance) { return reflectance; }

#endif
