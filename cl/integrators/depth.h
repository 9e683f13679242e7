// SPDX-License-Identifier: MIT
// Euclidean distance from the ray's origin to the first hit; 0 where nothing is hit.

FN int depth_step(const Scene* scene, Path* path, int hit, const Surface* s) {
  (void)scene;
  real depth = hit ? length3(sub3(s->position, path->ray.o)) : R(0.0);
  path_add(path, vec3(depth, depth, depth));
  return 0;
}
