// SPDX-License-Identifier: MIT
// Shading normal of the first hit in world axes as a colour: (n + 1) / 2; black where nothing is hit.

enum { normals_STEPS_w = 0 };

FN maskw normals_step_w(const Scene* scene, Paths_w* path, const Surfaces_w* s, PRIVATE int* next) {
  (void)scene;
  (void)next;
  realw middle = splat_w(R(0.5));
  path_add_w(path, path->alive & s->hit, fma3_w(middle, s->shading, vec3_w(middle, middle, middle)));
  return none_w();
}
