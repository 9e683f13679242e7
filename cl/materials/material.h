// SPDX-License-Identifier: MIT
// Dispatch over the active materials.
#ifndef STRAHL_MATERIALS_MATERIAL_H
#define STRAHL_MATERIALS_MATERIAL_H

#include "core/surface.h"
#include "materials/all.h"
#include "scene/scene.h"

/// f times |cos| for light from unit wi towards unit wo, both pointing away from the surface.
FN real3 material_eval(const Scene* scene, const Surface* s, real3 wi, real3 wo) {
  GLOBAL const int* row =
      scene->index + scene->index[HEADER_MATERIALS] + scene_part(scene, s->part)[PART_MATERIAL] * MATERIAL_INTS;
  real zero = R(0.0);
  real3 black = vec3(zero, zero, zero);
  real cos_i = dot3(wi, s->shading), cos_o = dot3(wo, s->shading);
  if (HAS_TWOSIDED && row[MATERIAL_TWOSIDED] != 0 && cos_o < zero) {
    cos_i = -cos_i;
    cos_o = -cos_o;
  }
  if (!(cos_i > zero && cos_o > zero)) return black;
  GLOBAL const real* params = scene->shading + row[MATERIAL_REALS];
  switch (row[MATERIAL_KIND]) {
#define MATERIAL(name)  \
  case MATERIAL_##name: \
    return name##_eval(params, cos_i, cos_o);
#include "materials/materials.def"
#undef MATERIAL
    default:
      (void)params;
      return black;
  }
}

#endif
