// SPDX-License-Identifier: MIT
// Emission, and light that reaches the first hit directly: from every light that is taken (those of a single direction
// at each point); from the other emitters by one place drawn on one of them and one direction drawn by the material,
// weighted as in path. Depth counts as in Mitsuba: 1 shows emission alone, 2 one bounce.

enum { direct_STEPS_w = STEP_LIGHTS | STEP_SCATTER };

FN maskw direct_step_w(const Scene* scene, Paths_w* path, const Surfaces_w* s, PRIVATE int* next) {
  int max_depth = scene->index[HEADER_MAX_DEPTH];
  if (max_depth != 0) path_add_light_w(scene, path, s);
  *next = STEP_LIGHTS | (scene->index[HEADER_GLOWS] != 0 ? STEP_SCATTER : 0);
  maskw on = path->alive & s->hit & lt_int_w(path->depth, splat_int_w(1));
  return max_depth >= 0 && max_depth < 2 ? none_w() : on;
}
