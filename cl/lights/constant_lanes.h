// SPDX-License-Identifier: MIT
// The same radiance from everywhere, seen by rays that leave the scene; every direction is drawn alike. Parameters:
// radiance r g b.

FN LANED(LightSample)
    LANED(constant_sample)(const Scene* scene, GLOBAL const int* row, real3w from, LANED(LightNumbers) numbers) {
  (void)from;
  LANED(LightSample) s = LANED(no_light)();
  s.towards = LANED(square_to_sphere)(numbers.u, numbers.v);
  s.t_max = splat_w(REAL_MAX);
  s.density = splat_w(R(0.25) * ONE_OVER_PI);
  s.radiance = splat3_w(load3(scene->shading + row[LIGHT_REALS]));
  return s;
}

FN realw LANED(constant_density)(const Scene* scene, GLOBAL const int* row, real3w from, real3w towards,
                                 const LANED(Surfaces) * s) {
  (void)scene;
  (void)row;
  (void)from;
  (void)towards;
  (void)s;
  return splat_w(R(0.25) * ONE_OVER_PI);
}

FN real3w LANED(constant_background)(const Scene* scene, GLOBAL const int* row, real3w towards) {
  (void)towards;
  return splat3_w(load3(scene->shading + row[LIGHT_REALS]));
}
