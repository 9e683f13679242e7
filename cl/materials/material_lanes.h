// SPDX-License-Identifier: MIT
// Surfaces as light meets them on its way to wo, and dispatch over the active materials. One width; no guard.
#include "materials/material_sample_lanes.h"
#include "materials/all_lanes.h"

typedef struct {
  intw kind;  ///< MATERIAL_...
  real3w reflectance;
  LANED(Frame) frame;  ///< z the shading normal; of a twosided material, that on the side of wo.
  real3w wo;           ///< Unit, in that frame.
} LANED(Material);

/// Lanes of that kind.
FN maskw LANED(is_material)(const LANED(Material) * m, int kind) {
  return ~nonzero_w(m->kind - splat_int_w(MATERIAL_COUNT == 1 ? 0 : kind));
}

/// rows: offsets into the index, one a lane.
FN real3w LANED(material_reflectance)(const Scene* scene, const LANED(Surfaces) * s, intw rows) {
  GLOBAL const int* index = scene->index;
  real3w reflectance = gather3_w(scene->shading, gather_int_w(index + MATERIAL_REALS, rows));
  if (TEXTURE_COUNT > 0) {
    intw textures = gather_int_w(index + MATERIAL_TEXTURE, rows);
    for (uint lanes = bits_w(s->hit & ~lt_int_w(textures, splat_int_w(0))); lanes != 0u; lanes &= lanes - 1u) {
      int i = first_bit(lanes);
      TexturePoint at = LANED(texture_point)(s, i);
      real3 value = texture_value(scene, get_int_w(&textures, i), &at);
      put_w(&reflectance.x, i, value.x);
      put_w(&reflectance.y, i, value.y);
      put_w(&reflectance.z, i, value.z);
    }
  }
  return reflectance;
}

/// wo: unit, in the world.
FN LANED(Material) LANED(material_at)(const Scene* scene, const LANED(Surfaces) * s, real3w wo) {
  LANED(Material) m;
  GLOBAL const int* index = scene->index;
  intw row = LANED(part_entry)(scene, s, PART_MATERIAL) * MATERIAL_INTS + splat_int_w(index[HEADER_MATERIALS]);
  m.kind = MATERIAL_COUNT == 1 ? splat_int_w(0) : gather_int_w(index + MATERIAL_KIND, row);
  m.reflectance = LANED(material_reflectance)(scene, s, row);
  real3w z = s->shading;
  if (HAS_TWOSIDED) {
    maskw is_twosided = nonzero_w(gather_int_w(index + MATERIAL_TWOSIDED, row));
    z = sel3_w(is_twosided & lt_w(dot3_w(wo, z), splat_w(R(0.0))), negate3_w(z), z);
  }
  m.frame = LANED(frame_around)(z);
  m.wo = LANED(to_frame)(&m.frame, wo);
  return m;
}

/// f times |cos| for light from wi, unit, in the world; density: how densely material_sample draws wi.
FN real3w LANED(material_eval)(const LANED(Material) * m, real3w wi, PRIVATE realw* density) {
  real3w in_frame = LANED(to_frame)(&m->frame, wi), value = LANED(black)();
  *density = splat_w(R(0.0));
  (void)in_frame;
#define MATERIAL(name)                                                                            \
  {                                                                                               \
    maskw is_one = LANED(is_material)(m, MATERIAL_##name);                                        \
    if (MATERIAL_COUNT == 1 || any_w(is_one)) {                                                   \
      *density = sel_w(is_one, LANED(name##_density)(m->reflectance, in_frame, m->wo), *density); \
      value = sel3_w(is_one, LANED(name##_eval)(m->reflectance, in_frame, m->wo), value);         \
    }                                                                                             \
  }
#include "materials/materials.def"
#undef MATERIAL
  return value;
}

/// wi comes out in the world.
FN LANED(MaterialSample) LANED(material_sample)(const LANED(Material) * m, realw u, realw v) {
  LANED(MaterialSample) s;
  s.wi = m->wo;
  s.weight = LANED(black)();
  s.density = splat_w(R(0.0));
  (void)u;
  (void)v;
#define MATERIAL(name)                                                                 \
  {                                                                                    \
    maskw is_one = LANED(is_material)(m, MATERIAL_##name);                             \
    if (MATERIAL_COUNT == 1 || any_w(is_one)) {                                        \
      LANED(MaterialSample) drawn = LANED(name##_sample)(m->reflectance, m->wo, u, v); \
      s.wi = sel3_w(is_one, drawn.wi, s.wi);                                           \
      s.weight = sel3_w(is_one, drawn.weight, s.weight);                               \
      s.density = sel_w(is_one, drawn.density, s.density);                             \
    }                                                                                  \
  }
#include "materials/materials.def"
#undef MATERIAL
  s.wi = LANED(from_frame)(&m->frame, s.wi);
  return s;
}

/// Share of the light from the mirrored direction that goes towards wo; black: no mirror, or seen from behind.
FN real3w LANED(material_mirror)(const LANED(Material) * m) {
  real3w share = LANED(black)();
  maskw is_front = lt_w(splat_w(R(0.0)), m->wo.z);
  (void)is_front;
#define MATERIAL(name) \
  share = sel3_w(is_front & LANED(is_material)(m, MATERIAL_##name), LANED(name##_mirror)(m->reflectance), share);
#include "materials/materials.def"
#undef MATERIAL
  return share;
}
