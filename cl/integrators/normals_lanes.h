// SPDX-License-Identifier: MIT
// Shading normal of the first hit in world axes as a colour: (n + 1) / 2; black where nothing is hit.

enum { LANED(normals_STEPS) = 0 };

FN maskw LANED(normals_step)(const Scene* scene, LANED(Paths) * path, const LANED(Surfaces) * s, PRIVATE int* next) {
  (void)scene;
  (void)next;
  realw middle = splat_w(R(0.5));
  LANED(path_add)(path, path->alive & s->hit, fma3_w(middle, s->shading, vec3_w(middle, middle, middle)));
  return none_w();
}
