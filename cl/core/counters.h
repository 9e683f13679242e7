// SPDX-License-Identifier: MIT
// Counts that add up over all work-items. Integers, so their order does not matter.
#ifndef STRAHL_CORE_COUNTERS_H
#define STRAHL_CORE_COUNTERS_H

#include "scene/scene.h"

FN void count_event(const Scene* scene, int counter) { atomic_inc(scene->counters + counter); }

#endif
