// SPDX-License-Identifier: MIT
// Dispatch over the active choosers: which light a point draws. One width; no guard.
#include "lights/light_table.h"

typedef struct {
  intw light;    ///< Row of the light table.
  realw rarity;  ///< One over its probability: exactly n where n lights are equally likely, in every precision.
} LightChoice_w;

#include "choosers/all_lanes.h"

/// Chooses one of the lights that are drawn from, of which there is at least one. Where there is only one, no number is
/// drawn.
FN LightChoice_w choose_light_w(const Scene* scene, const SampleState_w* sample, intw depth, real3w from) {
  LightChoice_w only;
  only.light = splat_int_w(scene->index[HEADER_LIGHTS_TAKEN]);
  only.rarity = splat_w(R(1.0));
  if (lights_drawn_from(scene) == 1) return only;
  uintw number = vertex_number_w(scene, sample, depth, USE_LIGHT);
  switch (scene->index[HEADER_CHOOSER]) {
#define CHOOSER(name)  \
  case CHOOSER_##name: \
    return name##_choose_w(scene, from, number);
#include "choosers/choosers.def"
#undef CHOOSER
    default:
      (void)from;
      (void)number;
      return only;
  }
}

/// One over the probability that choose_light returns these lights at `from`.
FN realw light_rarity_w(const Scene* scene, intw lights, real3w from) {
  // Then there are no tables.
  if (lights_drawn_from(scene) == 1) return splat_w(R(1.0));
  switch (scene->index[HEADER_CHOOSER]) {
#define CHOOSER(name)  \
  case CHOOSER_##name: \
    return name##_rarity_w(scene, lights, from);
#include "choosers/choosers.def"
#undef CHOOSER
    default:
      (void)lights;
      (void)from;
      return splat_w(R(1.0));
  }
}
