// SPDX-License-Identifier: MIT
// Bidirectional path tracing: a sample is a path from the camera and a path from a light, and every vertex of one is
// joined with every vertex of the other. So each path of light is found by several techniques, whose shares are
// weighted by how likely each of them makes it (E. Lafortune, Y. Willems, "Bi-Directional Path Tracing", Compugraphics
// 1993; E. Veach, L. Guibas, "Bidirectional Estimators for Light Transport", EGWR 1994). kernels/bidirectional.cl
// follows the paths (integrators/both_ends_lanes.h); depth counts as in path and ptracer.

enum { bdpt_STEPS_w = STEP_SCATTER | STEP_ROULETTE | STEP_ADJOINT };

/// Of both paths: where they go on.
FN maskw bdpt_step_w(const Scene* scene, Paths_w* path, const Surfaces_w* s, PRIVATE int* next) {
  *next = STEP_SCATTER | STEP_ROULETTE;
  return path->alive & s->hit & lt_int_w(path->depth, splat_int_w(scene->index[HEADER_MAX_DEPTH] - 1));
}
