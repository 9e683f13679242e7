// SPDX-License-Identifier: MIT
// Euclidean distance from the ray's origin to the first hit; 0 where nothing is hit.

FN real3 depth_radiance(const Scene* scene, const Ray* ray, int hit, const Surface* s, int id) {
  (void)id;
  (void)scene;
  real depth = hit ? length3(sub3(s->position, ray->o)) : R(0.0);
  return vec3(depth, depth, depth);
}
