// SPDX-License-Identifier: MIT
// Projector: places on its picture are drawn uniformly.

FN LightRay_w projector_ray_w(const Scene* scene, GLOBAL const int* row, LightNumbers_w numbers, Real2_w way) {
  GLOBAL const real* params = scene->shading + row[LIGHT_REALS];
  realw one = splat_w(R(1.0)), two = splat_w(R(2.0));
  real3 right = load3(params + 3), down = load3(params + 6);
  real over_right = R(1.0) / dot3(right, right), over_down = R(1.0) / dot3(down, down);
  (void)way;
  LightRay_w ray = no_light_ray_w();
  ray.from = splat3_w(load3(params));
  real3w out = fma3_w(fma_w(two, numbers.u, -one), splat3_w(scale3(over_right, right)), splat3_w(load3(params + 9)));
  out = fma3_w(fma_w(two, numbers.v, -one), splat3_w(scale3(over_down, down)), out);
  realw cosine = one / length3_w(out);
  ray.way = scale3_w(cosine, out);
  LightSample_w s = projector_sample_w(scene, row, point_in_way_w(ray.from, out), numbers);
  // The picture is 4 tan_x tan_y large at distance 1, and the solid angle of a part of it is the cube of the cosine.
  realw solid = splat_w(R(4.0) * real_sqrt(over_right * over_down)) * (cosine * cosine * cosine);
  ray.flux = scale3_w(solid, intensity_of_w(&s));
  return ray;
}

FN realw projector_spread_w(const Scene* scene, GLOBAL const int* row, real3w way) {
  GLOBAL const real* params = scene->shading + row[LIGHT_REALS];
  real3 right = load3(params + 3), down = load3(params + 6);
  realw cosine = dot3_w(way, splat3_w(load3(params + 9)));
  real picture = R(4.0) / real_sqrt(dot3(right, right) * dot3(down, down));
  return splat_w(R(1.0)) / (splat_w(picture) * (cosine * cosine * cosine));
}
