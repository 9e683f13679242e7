// SPDX-License-Identifier: MIT
// As direct, and on along mirror reflections until a surface is no mirror or no light is left: T. Whitted, "An Improved
// Illumination Model for Shaded Display", CACM 23(6), 1980, as a loop. The material draws no direction, so emitters are
// sampled only by places drawn on them. Emitters are hidden from the camera only. Depth counts as in Mitsuba: every
// mirror adds one. Where the depth has no limit, a path ends after WHITTED_LONGEST mirrors.

enum { whitted_STEPS_w = STEP_LIGHTS | STEP_DELTA };

FN maskw whitted_step_w(const Scene* scene, Paths_w* path, const Surfaces_w* s, PRIVATE int* next) {
  int max_depth = scene->index[HEADER_MAX_DEPTH];
  if (max_depth < 0) max_depth = WHITTED_LONGEST + 1;
  if (max_depth > 0) path_add_light_w(scene, path, s);
  *next = whitted_STEPS_w;
  return path->alive & s->hit & lt_int_w(path->depth, splat_int_w(max_depth - 1));
}
