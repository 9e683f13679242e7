// SPDX-License-Identifier: MIT
// Rays that leave lights: dispatch over the active lights, light by light. One width; no guard.

FN LightRay_w ray_of_light_w(const Scene* scene, int light, LightNumbers_w numbers, Real2_w way) {
  GLOBAL const int* row = light_row(scene, light);
  switch (row[LIGHT_KIND]) {
#define LIGHT(name)  \
  case LIGHT_##name: \
    return name##_ray_w(scene, row, numbers, way);
#define DELTA_LIGHT LIGHT
#include "lights/lights.def"
#undef DELTA_LIGHT
#undef LIGHT
    default:
      (void)numbers;
      (void)way;
      return no_light_ray_w();
  }
}

/// lights: of the lanes of `which`; the others carry nothing.
FN LightRay_w light_ray_w(const Scene* scene, maskw which, intw lights, LightNumbers_w numbers, Real2_w way) {
  LightRay_w ray = no_light_ray_w();
  for (uint lanes = bits_w(which); lanes != 0u;) {
    int light;
    maskw of_light = next_alike_w(lights, which, &lanes, &light);
    LightRay_w one = ray_of_light_w(scene, light, numbers, way);
    ray.from = sel3_w(of_light, one.from, ray.from);
    ray.way = sel3_w(of_light, one.way, ray.way);
    ray.flux = sel3_w(of_light, one.flux, ray.flux);
    ray.normal = sel3_w(of_light, one.normal, ray.normal);
    ray.bound = sel_w(of_light, one.bound, ray.bound);
    ray.is_surface = (of_light & one.is_surface) | (~of_light & ray.is_surface);
    ray.is_far = (of_light & one.is_far) | (~of_light & ray.is_far);
    ray.inverse = sel_w(of_light, one.inverse, ray.inverse);
  }
  return ray;
}

FN realw spread_of_light_w(const Scene* scene, int light, real3w way) {
  GLOBAL const int* row = light_row(scene, light);
  switch (row[LIGHT_KIND]) {
#define LIGHT(name)  \
  case LIGHT_##name: \
    return name##_spread_w(scene, row, way);
#define DELTA_LIGHT LIGHT
#include "lights/lights.def"
#undef DELTA_LIGHT
#undef LIGHT
    default:
      (void)way;
      return splat_w(R(1.0));
  }
}

/// name_spread of lights.def, of the lights of the lanes of `which`.
FN realw light_spread_w(const Scene* scene, maskw which, intw lights, real3w way) {
  realw spread = splat_w(R(1.0));
  for (uint lanes = bits_w(which); lanes != 0u;) {
    int light;
    maskw of_light = next_alike_w(lights, which, &lanes, &light);
    spread = sel_w(of_light, spread_of_light_w(scene, light, way), spread);
  }
  return spread;
}
