// SPDX-License-Identifier: MIT
// A surface that shines along its normals: each place in one direction. What flows through the surface is its exitance,
// as Mitsuba 3 has it under the name of radiance.

FN LightRay_w directionalarea_ray_w(const Scene* scene, GLOBAL const int* row, LightNumbers_w numbers, Real2_w way) {
  (void)way;
  LightRay_w ray = area_place_w(scene, row, numbers);
  ray.way = ray.normal;
  ray.flux = scale3_w(splat_w(R(1.0) / scene->shading[row[LIGHT_REALS] + AREA_INVERSE]), ray.flux);
  return ray;
}

FN realw directionalarea_spread_w(const Scene* scene, GLOBAL const int* row, real3w way) {
  (void)scene;
  (void)row;
  (void)way;
  return splat_w(REAL_MAX);
}
