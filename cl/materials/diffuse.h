// SPDX-License-Identifier: MIT
// Lambertian reflection, f = rho / pi. Parameters: rho r g b.
#ifndef STRAHL_MATERIALS_DIFFUSE_H
#define STRAHL_MATERIALS_DIFFUSE_H

#include "materials/material_sample.h"

FN real3 diffuse_eval(real3 reflectance, real3 wi, real3 wo) {
  if (!(wi.z > R(0.0) && wo.z > R(0.0))) return black3();
  return scale3(wi.z * ONE_OVER_PI, reflectance);
}

FN real diffuse_density(real3 reflectance, real3 wi, real3 wo) {
  (void)reflectance;
  return wi.z > R(0.0) && wo.z > R(0.0) ? wi.z * ONE_OVER_PI : R(0.0);
}

FN MaterialSample diffuse_sample(real3 reflectance, real3 wo, real u, real v) {
  MaterialSample s;
  s.wi = square_to_cosine_hemisphere(u, v);
  s.weight = wo.z > R(0.0) ? reflectance : black3();
  s.density = s.wi.z * ONE_OVER_PI;
  return s;
}

FN real3 diffuse_mirror(real3 reflectance) {
  (void)reflectance;
  return black3();
}

#endif
