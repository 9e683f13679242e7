// SPDX-License-Identifier: MIT
// The first hit's own light, no lighting: "ray traced, self-luminous" of the course that strahl grew from.

FN real3 emission_radiance(const Scene* scene, const Ray* ray, int hit, const Surface* s, int id) {
  (void)id;
  if (scene->index[HEADER_HIDE_EMITTERS] != 0) return vec3(R(0.0), R(0.0), R(0.0));
  return hit ? emitted_radiance(scene, s, ray->d) : background_radiance(scene);
}
