// SPDX-License-Identifier: MIT
// Shading normal of the first hit in world axes as a colour: (n + 1) / 2; black where nothing is hit.

FN int normals_step(const Scene* scene, Path* path, int hit, const Surface* s) {
  (void)scene;
  real half_ = R(0.5);
  if (hit) path_add(path, fma3(half_, s->shading, vec3(half_, half_, half_)));
  return 0;
}
