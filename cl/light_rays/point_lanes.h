// SPDX-License-Identifier: MIT
// Point light: the same in all directions.

FN LightRay_w point_ray_w(const Scene* scene, GLOBAL const int* row, LightNumbers_w numbers, Real2_w way) {
  GLOBAL const real* params = scene->shading + row[LIGHT_REALS];
  (void)way;
  LightRay_w ray = no_light_ray_w();
  ray.from = splat3_w(load3(params));
  ray.way = square_to_sphere_w(numbers.u, numbers.v);
  ray.flux = scale3_w(splat_w(R(4.0) * PI), splat3_w(load3(params + 3)));
  return ray;
}

FN realw point_spread_w(const Scene* scene, GLOBAL const int* row, real3w way) {
  (void)scene;
  (void)row;
  (void)way;
  return splat_w(R(0.25) / PI);
}
