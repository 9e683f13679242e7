// SPDX-License-Identifier: MIT
// Ambient occlusion: the share of ways from the first hit into the open (core/openness.h) that meet nothing within a
// reach. Materials and lights do not count; black where nothing is hit.

enum { ao_STEPS_w = STEP_OPENNESS };

FN maskw ao_step_w(const Scene* scene, Paths_w* path, const Surfaces_w* s, PRIVATE int* next) {
  (void)scene;
  *next = ao_STEPS_w;
  return path->alive & s->hit;
}
