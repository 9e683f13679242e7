// SPDX-License-Identifier: MIT
// Euclidean distance from the ray's origin to the first hit; 0 where nothing is hit.

enum { LANED(depth_STEPS) = 0 };

FN maskw LANED(depth_step)(const Scene* scene, LANED(Paths) * path, const LANED(Surfaces) * s, PRIVATE int* next) {
  (void)scene;
  (void)next;
  realw depth = length3_w(sub3_w(s->position, LANED(real3_at)(path->rays.planes + RAY_PLANE_O)));
  LANED(path_add)(path, path->alive & s->hit, vec3_w(depth, depth, depth));
  return none_w();
}
