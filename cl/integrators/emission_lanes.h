// SPDX-License-Identifier: MIT
// The first hit's own light, no lighting: "ray traced, self-luminous" of the course that strahl grew from.

enum { LANED(emission_STEPS) = 0 };

FN maskw LANED(emission_step)(const Scene* scene, LANED(Paths) * path, const LANED(Surfaces) * s, PRIVATE int* next) {
  (void)next;
  LANED(path_add)(path, LANED(is_light_shown)(scene, path), LANED(radiance_along)(scene, path, s));
  return none_w();
}
