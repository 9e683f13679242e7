// SPDX-License-Identifier: MIT
// Euclidean distance from the ray's origin to the first hit; 0 where nothing is hit.

enum { depth_STEPS_w = 0 };

FN maskw depth_step_w(const Scene* scene, Paths_w* path, const Surfaces_w* s, PRIVATE int* next) {
  (void)scene;
  (void)next;
  realw depth = length3_w(sub3_w(s->position, real3_at_w(path->rays.planes + RAY_PLANE_O)));
  path_add_w(path, path->alive & s->hit, vec3_w(depth, depth, depth));
  return none_w();
}
