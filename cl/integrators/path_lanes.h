// SPDX-License-Identifier: MIT
// Global illumination: at every surface a place drawn on one light and a direction drawn by the material, both weighted
// by the power heuristic with exponent 2, and Russian roulette. J. Kajiya, "The Rendering Equation", SIGGRAPH 1986; E.
// Veach, L. Guibas, "Optimally Combining Sampling Techniques for Monte Carlo Rendering", SIGGRAPH 1995. max_depth,
// rr_depth and hide_emitters as in Mitsuba; the host states a max_depth where the scene has none (ROULETTE_LONGEST).

enum { path_STEPS_w = STEP_LIGHTS | STEP_SCATTER | STEP_ROULETTE };

FN maskw path_step_w(const Scene* scene, Paths_w* path, const Surfaces_w* s, PRIVATE int* next) {
  int max_depth = scene->index[HEADER_MAX_DEPTH];
  if (max_depth > 0) path_add_light_w(scene, path, s);
  *next = path_STEPS_w;
  return path->alive & s->hit & lt_int_w(path->depth, splat_int_w(max_depth - 1));
}
