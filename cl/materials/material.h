// SPDX-License-Identifier: MIT
// Dispatch over the active materials.
#ifndef STRAHL_MATERIALS_MATERIAL_H
#define STRAHL_MATERIALS_MATERIAL_H

#include "core/surface.h"
#include "materials/all.h"
#include "scene/scene.h"
#include "textures/texture.h"

FN GLOBAL const int* material_row(const Scene* scene, const Surface* s) {
  return scene->index + scene->index[HEADER_MATERIALS] + scene_part(scene, s->part)[PART_MATERIAL] * MATERIAL_INTS;
}

FN real3 material_reflectance(const Scene* scene, GLOBAL const int* row, const Surface* s) {
  if (TEXTURE_COUNT > 0 && row[MATERIAL_TEXTURE] >= 0) return texture_value(scene, row[MATERIAL_TEXTURE], s);
  return load3(scene->shading + row[MATERIAL_REALS]);
}

/// f times |cos| for light from unit wi towards unit wo, both pointing away from the surface.
FN real3 material_eval(const Scene* scene, const Surface* s, real3 wi, real3 wo) {
  GLOBAL const int* row = material_row(scene, s);
  real zero = R(0.0);
  real3 black = vec3(zero, zero, zero);
  real cos_i = dot3(wi, s->shading), cos_o = dot3(wo, s->shading);
  if (HAS_TWOSIDED && row[MATERIAL_TWOSIDED] != 0 && cos_o < zero) {
    cos_i = -cos_i;
    cos_o = -cos_o;
  }
  if (!(cos_i > zero && cos_o > zero)) return black;
  switch (row[MATERIAL_KIND]) {
#define MATERIAL(name)  \
  case MATERIAL_##name: \
    return name##_eval(material_reflectance(scene, row, s), cos_i, cos_o);
#include "materials/materials.def"
#undef MATERIAL
    default:
      return black;
  }
}

/// Share of the light from the mirrored direction that goes towards unit wo; black: no mirror, or seen from behind.
FN real3 material_mirror(const Scene* scene, const Surface* s, real3 wo) {
  GLOBAL const int* row = material_row(scene, s);
  real zero = R(0.0);
  real3 black = vec3(zero, zero, zero);
  real cos_o = dot3(wo, s->shading);
  int seen = HAS_TWOSIDED && row[MATERIAL_TWOSIDED] != 0 ? cos_o != zero : cos_o > zero;
  if (!seen) return black;
  switch (row[MATERIAL_KIND]) {
#define MATERIAL(name)  \
  case MATERIAL_##name: \
    return name##_mirror(material_reflectance(scene, row, s));
#include "materials/materials.def"
#undef MATERIAL
    default:
      return black;
  }
}

#endif
