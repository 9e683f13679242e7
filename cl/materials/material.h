// SPDX-License-Identifier: MIT
// A surface as light meets it on its way to wo, and dispatch over the active materials.
#ifndef STRAHL_MATERIALS_MATERIAL_H
#define STRAHL_MATERIALS_MATERIAL_H

#include "core/surface.h"
#include "materials/all.h"
#include "materials/material_sample.h"
#include "scene/scene.h"
#include "textures/texture.h"

typedef struct {
  int kind;  ///< MATERIAL_...
  real3 reflectance;
  real3 x, y, z;  ///< Frame: z the shading normal; of a twosided material, that on the side of wo.
  real3 wo;       ///< Unit, in that frame.
} Material;

FN GLOBAL const int* material_row(const Scene* scene, const Surface* s) {
  return scene->index + scene->index[HEADER_MATERIALS] + scene_part(scene, s->part)[PART_MATERIAL] * MATERIAL_INTS;
}

FN real3 material_reflectance(const Scene* scene, GLOBAL const int* row, const Surface* s) {
  if (TEXTURE_COUNT > 0 && row[MATERIAL_TEXTURE] >= 0) return texture_value(scene, row[MATERIAL_TEXTURE], s);
  return load3(scene->shading + row[MATERIAL_REALS]);
}

FN real3 to_material(const Material* m, real3 world) {
  return vec3(dot3(world, m->x), dot3(world, m->y), dot3(world, m->z));
}

/// wo: unit, in the world.
FN Material material_at(const Scene* scene, const Surface* s, real3 wo) {
  Material m;
  GLOBAL const int* row = material_row(scene, s);
  m.kind = row[MATERIAL_KIND];
  m.reflectance = material_reflectance(scene, row, s);
  int is_behind = HAS_TWOSIDED && row[MATERIAL_TWOSIDED] != 0 && dot3(wo, s->shading) < R(0.0);
  m.z = is_behind ? negate3(s->shading) : s->shading;
  frame_around(m.z, &m.x, &m.y);
  m.wo = to_material(&m, wo);
  return m;
}

/// f times |cos| for light from wi, unit, in the world; density: how densely material_sample draws wi.
FN real3 material_eval(const Material* m, real3 wi, real* density) {
  real3 in_frame = to_material(m, wi);
  *density = R(0.0);
  switch (m->kind) {
#define MATERIAL(name)                                          \
  case MATERIAL_##name:                                         \
    *density = name##_density(m->reflectance, in_frame, m->wo); \
    return name##_eval(m->reflectance, in_frame, m->wo);
#include "materials/materials.def"
#undef MATERIAL
    default:
      (void)in_frame;
      return black3();
  }
}

/// wi comes out in the world.
FN MaterialSample material_sample(const Material* m, real u, real v) {
  MaterialSample s;
  switch (m->kind) {
#define MATERIAL(name)                              \
  case MATERIAL_##name:                             \
    s = name##_sample(m->reflectance, m->wo, u, v); \
    break;
#include "materials/materials.def"
#undef MATERIAL
    default:
      (void)u;
      (void)v;
      s.wi = m->wo;
      s.weight = black3();
      s.density = R(0.0);
      break;
  }
  s.wi = from_frame(m->x, m->y, m->z, s.wi);
  return s;
}

/// Share of the light from the mirrored direction that goes towards wo; black: no mirror, or seen from behind.
FN real3 material_mirror(const Material* m) {
  if (!(m->wo.z > R(0.0))) return black3();
  switch (m->kind) {
#define MATERIAL(name)  \
  case MATERIAL_##name: \
    return name##_mirror(m->reflectance);
#include "materials/materials.def"
#undef MATERIAL
    default:
      return black3();
  }
}

#endif
