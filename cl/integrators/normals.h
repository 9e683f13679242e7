// SPDX-License-Identifier: MIT
// Shading normal of the first hit in world axes as a colour: (n + 1) / 2; black where nothing is hit.

FN real3 normals_radiance(const Scene* scene, const Ray* ray, int hit, const Surface* s, int id) {
  (void)id;
  (void)scene;
  (void)ray;
  real half_ = R(0.5), zero = R(0.0);
  if (!hit) return vec3(zero, zero, zero);
  return fma3(half_, s->shading, vec3(half_, half_, half_));
}
