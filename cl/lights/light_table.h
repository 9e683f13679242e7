// SPDX-License-Identifier: MIT
// The table of lights (scene/layout.h, LIGHT_...), the same for every width.
#ifndef STRAHL_LIGHTS_LIGHT_TABLE_H
#define STRAHL_LIGHTS_LIGHT_TABLE_H

#include "scene/scene.h"

FN GLOBAL const int* light_row(const Scene* scene, int light) {
  return scene->index + scene->index[HEADER_LIGHTS] + light * LIGHT_INTS;
}

/// Lights after those that every surface takes.
FN int lights_drawn_from(const Scene* scene) {
  return scene->index[HEADER_LIGHT_COUNT] - scene->index[HEADER_LIGHTS_TAKEN];
}

/// The light from afar that the header names; -1: none, or none that is drawn.
FN int drawn_afar(const Scene* scene, int header) {
  int light = scene->index[header];
  return light < scene->index[HEADER_LIGHT_COUNT] ? light : -1;
}

/// The camera looks through what glows.
FN int hides_emitters(const Scene* scene) { return HAS_HIDE_EMITTERS && scene->index[HEADER_HIDE_EMITTERS] != 0; }

#endif
