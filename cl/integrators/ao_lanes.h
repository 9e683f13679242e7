// SPDX-License-Identifier: MIT
// Ambient occlusion: the share of ways from the first hit into the open (core/openness.h) that meet nothing within a
// reach. Materials and lights do not count; black where nothing is hit.

enum { LANED(ao_STEPS) = STEP_OPENNESS };

FN maskw LANED(ao_step)(const Scene* scene, LANED(Paths) * path, const LANED(Surfaces) * s, PRIVATE int* next) {
  (void)scene;
  *next = LANED(ao_STEPS);
  return path->alive & s->hit;
}
