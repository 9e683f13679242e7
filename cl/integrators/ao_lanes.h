// SPDX-License-Identifier: MIT
// Ambient occlusion: the share of directions from the first hit (integrators/openness_lanes.h) in which nothing is met
// within a given distance. Materials and lights do not matter; black where nothing is hit.

enum { ao_STEPS_w = STEP_OPENNESS };

FN maskw ao_step_w(const Scene* scene, Paths_w* path, const Surfaces_w* s, PRIVATE int* next) {
  (void)scene;
  *next = ao_STEPS_w;
  return path->alive & s->hit;
}
