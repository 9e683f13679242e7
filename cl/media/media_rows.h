// SPDX-License-Identifier: MIT
// The enumerators of the active media and phase functions, and the rows of media (media/media_layout.h).
#ifndef STRAHL_MEDIA_MEDIA_ROWS_H
#define STRAHL_MEDIA_MEDIA_ROWS_H

#include "media/media_layout.h"
#include "scene/scene.h"

enum {
#define MEDIUM(name) MEDIUM_##name,
#include "media/media.def"
#undef MEDIUM
  MEDIUM_COUNT
};

enum {
#define PHASE(name) PHASE_##name,
#include "phases/phases.def"
#undef PHASE
  PHASE_COUNT
};

/// MEDIA_INTS.
FN GLOBAL const int* media_table(const Scene* scene) {
  return scene->index + HEADER_INTS + (SHAPE_COUNT + HAS_INSTANCES) * SHAPE_INTS;
}

FN GLOBAL const int* medium_row(const Scene* scene, int medium) {
  return scene->index + media_table(scene)[MEDIA_ROWS] + medium * MEDIUM_INTS;
}

#endif
