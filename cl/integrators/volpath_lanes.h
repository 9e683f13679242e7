// SPDX-License-Identifier: MIT
// As path, through media: paths scatter within them, and light is weakened on its way. Surfaces that let light pass as
// it came, of null or masked materials, do not count as depth, and lights are seen through them (as Mitsuba's volpath).
// J. Kajiya, B. Von Herzen, "Ray Tracing Volume Densities", SIGGRAPH 1984; M. Raab, D. Seibert, A. Keller, "Unbiased
// Global Illumination with Participating Media", MCQMC 2006.

enum { volpath_STEPS_w = STEP_LIGHTS | STEP_SCATTER | STEP_ROULETTE | STEP_THROUGH };

FN maskw volpath_step_w(const Scene* scene, Paths_w* path, const Surfaces_w* s, PRIVATE int* next) {
  int max_depth = scene->index[HEADER_MAX_DEPTH];
  if (max_depth > 0) path_add_light_w(scene, path, s);
  *next = volpath_STEPS_w;
  // At its last depth a path still passes what does not count, towards lights (surface_scatter_w).
  return path->alive & s->hit & lt_int_w(path->depth, splat_int_w(max_depth));
}
