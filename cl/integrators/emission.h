// SPDX-License-Identifier: MIT
// The first hit's own light, no lighting: "ray traced, self-luminous" of the course that strahl grew from.

FN int emission_step(const Scene* scene, Path* path, int hit, const Surface* s) {
  if (is_light_shown(scene, path)) path_add(path, radiance_along(scene, hit, s));
  return 0;
}
