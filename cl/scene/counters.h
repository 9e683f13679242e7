// SPDX-License-Identifier: MIT
// Counts that add up over all work-items. Integers, so their order does not matter.
#ifndef STRAHL_SCENE_COUNTERS_H
#define STRAHL_SCENE_COUNTERS_H

#include "scene/scene.h"

FN void count_events(const Scene* scene, int counter, uint number) {
  add_atomically(scene->counters + counter, number);
}

FN void count_event(const Scene* scene, int counter) { count_events(scene, counter, 1u); }

/// With HAS_LOOP_LIMIT. first: the sample that a work-item began this launch with; next: the first that is not there
/// yet; end: of the launch's samples.
FN void count_unfinished(const Scene* scene, int first, int next, int end) {
  if (next >= end) return;
  count_event(scene, COUNT_CUT);
  if (next <= first) count_event(scene, COUNT_STUCK);
}

/// How many bits are set.
FN uint lanes_among(uint bits) {
  uint lanes = 0u;
  for (; bits != 0u; bits &= bits - 1u) ++lanes;
  return lanes;
}

/// Primitives among the ids of so many slots; the others are padding.
FN uint primitives_among(GLOBAL const int* ids, int slots) {
  uint primitives = 0u;
  for (int i = 0; i < slots; ++i) primitives += ids[i] < 0 ? 0u : 1u;
  return primitives;
}

#endif
