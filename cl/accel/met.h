// SPDX-License-Identifier: MIT
// Which shapes rays meet: those of the scene's header, or those of a group of their own, as boundaries of media are
// (media/boundaries_lanes.h).
#ifndef STRAHL_ACCEL_MET_H
#define STRAHL_ACCEL_MET_H

#include "scene/scene.h"

/// Shapes that rays meet may stand in a list and a tree of their own.
#if HAS_MEDIA
enum { HAS_GROUPS = 1 };
#else
enum { HAS_GROUPS = HAS_INSTANCES };
#endif

/// As Scene has it.
FN GLOBAL const int* scene_met(const Scene* scene) {
#if HAS_MEDIA
  return scene->met;
#else
  (void)scene;
  return (GLOBAL const int*)0;
#endif
}

/// How many blocks of the kind stand in lists outside of instances.
FN int scene_listed(const Scene* scene, int kind) {
  GLOBAL const int* met = scene_met(scene);
  if (HAS_GROUPS && met != 0) return kind == SHAPE_COUNT ? 0 : met[GROUP_LISTED + 2 * kind + 1];
  return scene_shape_row(scene, kind)[SHAPE_LISTED];
}

/// The tree outside of instances; NO_REFERENCE: there is none.
FN int scene_root(const Scene* scene) {
  GLOBAL const int* met = scene_met(scene);
  return HAS_GROUPS && met != 0 ? met[GROUP_ROOT] : scene->index[HEADER_ROOT];
}

/// What bounds it, as at HEADER_BOUNDS.
FN GLOBAL const real* scene_reach(const Scene* scene) {
  GLOBAL const int* met = scene_met(scene);
  return scene->geometry + (HAS_GROUPS && met != 0 ? met[GROUP_BOUNDS] : scene->index[HEADER_BOUNDS]);
}

#endif
