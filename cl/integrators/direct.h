// SPDX-License-Identifier: MIT
// Emission, and light that reaches the first hit straight: from every point and directional light, and from what else
// emits by one place drawn on it and one way drawn by the material, weighted as in path. Depth counts as in Mitsuba: 1
// shows emission alone, 2 one bounce.

FN int direct_step(const Scene* scene, Path* path, int hit, const Surface* s) {
  int max_depth = scene->index[HEADER_MAX_DEPTH];
  if (max_depth != 0 && is_light_shown(scene, path)) path_add_light(scene, path, hit, s);
  if (!hit || path->depth > 0 || (max_depth >= 0 && max_depth < 2)) return 0;
  return STEP_LIGHTS | (scene->index[HEADER_GLOWS] != 0 ? STEP_SCATTER : 0);
}
