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
  s.irradiance = scale3_w(splat_w(R(1.0)) / s.density, splat3_w(load3(scene->shading + row[LIGHT_REALS])));
  return s;
}

FN realw LANED(constant_density)(const Scene* scene, GLOBAL const int* row, real3w from, const LANED(Surfaces) * s) {
  (void)scene;
  (void)row;
  (void)from;
  (void)s;
  return splat_w(R(0.25) * ONE_OVER_PI);
}

FN real3 LANED(constant_background)(GLOBAL const real* params) { return load3(params); }
