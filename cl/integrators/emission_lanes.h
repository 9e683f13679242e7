// SPDX-License-Identifier: MIT
// The first hit's own light, no lighting: "ray traced, self-luminous" of the course that strahl grew from.

enum { emission_STEPS_w = 0 };

FN maskw emission_step_w(const Scene* scene, Paths_w* path, const Surfaces_w* s, PRIVATE int* next) {
  (void)next;
  if (scene->index[HEADER_MAX_DEPTH] == 0) return none_w();
  path_add_w(path, is_light_shown_w(scene, path), light_along_w(scene, path, s).radiance);
  if (HAS_SUN) path_add_w(path, is_light_shown_w(scene, path), sun_along_w(scene, path, s).radiance);
  return none_w();
}
