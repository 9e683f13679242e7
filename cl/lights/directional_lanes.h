// SPDX-License-Identifier: MIT
// Light from infinitely far away. Parameters: unit direction of travel x y z, irradiance r g b (W/m^2).

FN LANED(LightSample)
    LANED(directional_sample)(const Scene* scene, GLOBAL const int* row, real3w from, LANED(LightNumbers) numbers) {
  GLOBAL const real* params = scene->shading + row[LIGHT_REALS];
  (void)from;
  (void)numbers;
  LANED(LightSample) s = LANED(no_light)();
  s.towards = splat3_w(negate3(load3(params)));
  s.t_max = splat_w(REAL_MAX);
  s.radiance = splat3_w(load3(params + 3));
  s.is_delta = ~none_w();
  return s;
}

FN realw LANED(directional_density)(const Scene* scene, GLOBAL const int* row, real3w from, real3w towards,
                                    const LANED(Surfaces) * s) {
  (void)scene;
  (void)row;
  (void)from;
  (void)towards;
  (void)s;
  return splat_w(R(0.0));
}

FN real3w LANED(directional_background)(const Scene* scene, GLOBAL const int* row, real3w towards) {
  (void)scene;
  (void)row;
  (void)towards;
  return splat3_w(vec3(R(0.0), R(0.0), R(0.0)));
}
