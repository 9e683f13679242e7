// SPDX-License-Identifier: MIT
// Emission plus light that reaches the first hit straight from point and directional lights, with hard shadows.
// Mirrors look black. Depth counts as in Mitsuba: 1 shows emission alone, 2 one bounce.

FN int direct_step(const Scene* scene, Path* path, int hit, const Surface* s) {
  int max_depth = scene->index[HEADER_MAX_DEPTH];
  if (max_depth != 0 && scene->index[HEADER_HIDE_EMITTERS] == 0) path_add(path, radiance_along(scene, path, hit, s));
  return hit && (max_depth < 0 || max_depth >= 2) ? STEP_LAMPS : 0;
}
