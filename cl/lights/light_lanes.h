// SPDX-License-Identifier: MIT
// Dispatch over the active lights: all lanes whose lights lie alike are evaluated together. Also the radiance that
// surfaces emit. One width; no guard.
#include "lights/light_table.h"
#include "lights/light_rows_lanes.h"
#include "lights/light_sample_lanes.h"
#include "lights/choice_lanes.h"
#include "textures/texture_lanes.h"
#include "lights/all_lanes.h"
#include "choosers/chooser_lanes.h"

/// Of all active lights.
enum {
  LIGHT_NUMBERS_w = 0
#define LIGHT(name) | (int)name##_NUMBERS_w
#define DELTA_LIGHT LIGHT
#include "lights/lights.def"
#undef DELTA_LIGHT
#undef LIGHT
};

/// The numbers with which a light draws a place at a vertex. Only a scene whose emitters have several items draws an
/// item.
FN LightNumbers_w light_numbers_w(const Scene* scene, const SampleState_w* sample, intw depth) {
  LightNumbers_w numbers = no_numbers_w();
  Random2_w place = vertex_pair_w(scene, sample, depth, USE_PLACE);
  numbers.u = random_between_w(place.x);
  numbers.v = random_between_w(place.y);
  if (AREA_COUNT > 0 && scene->index[HEADER_MOST_ITEMS] > 1)
    numbers.item = vertex_number_w(scene, sample, depth, USE_ITEM);
  if ((LIGHT_NUMBERS_w & NUMBERS_TEXEL_w) != 0) {
    Random2_w texel = vertex_pair_w(scene, sample, depth, USE_TEXEL);
    numbers.row = texel.x;
    numbers.column = texel.y;
  }
  return numbers;
}

FN LightSample_w sample_of_lights_w(const Scene* scene, const LightRows_w* at, real3w from, LightNumbers_w numbers) {
  switch (at->row[LIGHT_KIND]) {
#define LIGHT(name)  \
  case LIGHT_##name: \
    return name##_sample_w(scene, at, from, numbers);
#define DELTA_LIGHT LIGHT
#include "lights/lights.def"
#undef DELTA_LIGHT
#undef LIGHT
    default:
      (void)scene;
      (void)from;
      (void)numbers;
      return no_light_w();
  }
}

/// lights: of the lanes of `which`. Those that lie alike are asked together.
FN LightSample_w light_sample_w(const Scene* scene, maskw which, intw lights, real3w from, LightNumbers_w numbers) {
  LightSample_w sample = no_light_w();
  if (!any_w(which)) return sample;
  intw row = sel_int_w(which, lights, splat_int_w(0)) * splat_int_w(LIGHT_INTS);
  intw alike = gather_int_w(light_row(scene, 0) + LIGHT_ALIKE, row);
  for (uint lanes = bits_w(which); lanes != 0u;) {
    int one = get_int_w(&lights, first_bit(lanes)), unused;
    maskw of_lights = next_alike_w(alike, which, &lanes, &unused);
    LightRows_w at = rows_of_lights_w(scene, sel_int_w(of_lights, lights, splat_int_w(one)));
    sample = sel_light_w(of_lights, sample_of_lights_w(scene, &at, from, numbers), sample);
  }
  return sample;
}

FN realw density_of_light_w(const Scene* scene, int light, real3w from, real3w towards, const Surfaces_w* s) {
  LightRows_w at = rows_of_light_w(scene, light_row(scene, light));
  switch (at.row[LIGHT_KIND]) {
#define LIGHT(name)  \
  case LIGHT_##name: \
    return name##_density_w(scene, &at, from, towards, s);
#define DELTA_LIGHT(name)
#include "lights/lights.def"
#undef DELTA_LIGHT
#undef LIGHT
    default:
      (void)from;
      (void)towards;
      (void)s;
      return splat_w(R(0.0));
  }
}

/// The density with which light_sample draws the directions along which rays have hit the lights, at s if the lights
/// have surfaces. Few rays hit any, so these are asked light by light.
FN realw light_density_w(const Scene* scene, maskw which, intw lights, real3w from, real3w towards,
                         const Surfaces_w* s) {
  realw density = splat_w(R(0.0));
  for (uint lanes = bits_w(which); lanes != 0u;) {
    int light;
    maskw of_light = next_alike_w(lights, which, &lanes, &light);
    density = sel_w(of_light, density_of_light_w(scene, light, from, towards, s), density);
  }
  return density;
}

/// What rays that leave the scene find of the light that the header names: the background or the sun.
FN FoundLight_w far_light_w(const Scene* scene, int header, real3w towards) {
  int light = LIGHT_COUNT == 0 ? -1 : scene->index[header];
  if (light < 0) return no_light_found_w();
  GLOBAL const int* row = light_row(scene, light);
  switch (row[LIGHT_KIND]) {
#define LIGHT(name)  \
  case LIGHT_##name: \
    return name##_background_w(scene, row, towards);
#define DELTA_LIGHT(name)
#include "lights/lights.def"
#undef DELTA_LIGHT
#undef LIGHT
    default:
      (void)towards;
      return no_light_found_w();
  }
}

/// Radiance that surfaces emit against the rays' directions: on the side of their normals only.
FN real3w emitted_radiance_w(const Scene* scene, const Surfaces_w* s) {
  realw zero = splat_w(R(0.0));
  real3w radiance = vec3_w(zero, zero, zero);
  if (HAS_EMISSION) {
    intw at = part_entry_w(scene, s, PART_RADIANCE);
    maskw emits = s->hit & lt_w(s->facing, zero) & ~lt_int_w(at, splat_int_w(0));
    if (any_w(emits)) {
      at = sel_int_w(emits, at, splat_int_w(0));
      radiance = sel3_w(emits, gather3_w(scene->shading, at), radiance);
      if (HAS_LIGHT_TEXTURE) {
        intw textures = part_entry_w(scene, s, PART_GLOW);
        maskw is_textured = emits & ~lt_int_w(textures, splat_int_w(0));
        real3w shares = textures_at_w(scene, is_textured, textures, texture_point_w(scene, s), radiance);
        radiance = sel3_w(is_textured, mul3_w(radiance, shares), radiance);
      }
    }
  }
  return radiance;
}
