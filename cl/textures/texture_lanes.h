// SPDX-License-Identifier: MIT
// Dispatch over the active textures, texture by texture: all lanes of one texture are evaluated together. One width; no
// guard.

#include "textures/place_lanes.h"
#include "textures/all_lanes.h"

/// Of one texture. Every parameter of every material asks for it: inlined, textures were three quarters of a program
/// with everything.
ONCE_FN real3w texture_value_w(const Scene* scene, int texture, const TexturePlace_w* at) {
  GLOBAL const int* row = scene->index + scene->index[HEADER_TEXTURES] + texture * TEXTURE_INTS;
  switch (row[TEXTURE_KIND]) {
#define TEXTURE(name)  \
  case TEXTURE_##name: \
    return name##_value_w(scene, row, *at);
#include "textures/textures.def"
#undef TEXTURE
    default:
      (void)at;
      return splat3_w(vec3(R(0.0), R(0.0), R(0.0)));
  }
}

/// How the luminance of one texture changes with u and v.
ONCE_FN Real2_w texture_slope_w(const Scene* scene, int texture, const TexturePlace_w* at) {
  GLOBAL const int* row = scene->index + scene->index[HEADER_TEXTURES] + texture * TEXTURE_INTS;
  Real2_w none;
  switch (row[TEXTURE_KIND]) {
#define TEXTURE(name)  \
  case TEXTURE_##name: \
    return name##_slope_w(scene, row, *at);
#include "textures/textures.def"
#undef TEXTURE
    default:
      (void)at;
      none.x = none.y = splat_w(R(0.0));
      return none;
  }
}

/// A point without a footprint, of no mesh.
FN TexturePlace_w texture_at_w(realw u, realw v) {
  TexturePlace_w at;
  at.u = at.own_u = u;
  at.v = at.own_v = v;
  at.du = at.dv = splat_w(R(0.0));
  at.part = at.primitive = splat_int_w(0);
  return at;
}

/// Points of surfaces.
FN TexturePlace_w texture_point_w(const Scene* scene, const Surfaces_w* s) {
  TexturePlace_w at = texture_at_w(s->tex_u, s->tex_v);
  if (HAS_MESH_ATTRIBUTE) {
    at.own_u = s->own_u;
    at.own_v = s->own_v;
    at.part = s->part;
    at.primitive = s->id - part_entry_w(scene, s, PART_FIRST_ID);
  }
  return at;
}

/// texture_slope of the textures in the lanes of `which`; 0 in the others.
FN Real2_w texture_slopes_w(const Scene* scene, const Surfaces_w* s, maskw which, intw textures) {
  Real2_w slope;
  slope.x = slope.y = splat_w(R(0.0));
  TexturePlace_w at = texture_point_w(scene, s);
  for (uint lanes = bits_w(which); lanes != 0u;) {
    int texture;
    maskw is_one = next_alike_w(textures, which, &lanes, &texture);
    Real2_w found = texture_slope_w(scene, texture, &at);
    slope.x = sel_w(is_one, found.x, slope.x);
    slope.y = sel_w(is_one, found.y, slope.y);
  }
  return slope;
}

/// Those textures in the lanes of `which`, and `value` in the others.
INLINE_FN real3w textures_at_w(const Scene* scene, maskw which, intw textures, TexturePlace_w at, real3w value) {
  for (uint lanes = bits_w(which); lanes != 0u;) {
    int texture;
    maskw is_one = next_alike_w(textures, which, &lanes, &texture);
    value = sel3_w(is_one, texture_value_w(scene, texture, &at), value);
  }
  return value;
}

/// Points of surfaces, as wide as the pixel is there; undefined where no texture is.
FN TexturePlace_w texture_place_w(const Scene* scene, const Surfaces_w* s) {
  TexturePlace_w at = texture_point_w(scene, s);
  maskw which = at_surfaces_w(s);
  if (TEXTURE_COUNT == 0 || !any_w(which)) return at;
  intw rates = part_entry_w(scene, s, PART_UV_RATES), zero = splat_int_w(0);
  rates = sel_int_w(which & ~lt_int_w(rates, zero), rates, zero);
  at.du = s->footprint * gather_w(scene->shading, rates);
  at.dv = s->footprint * gather_w(scene->shading + 1, rates);
  return at;
}
