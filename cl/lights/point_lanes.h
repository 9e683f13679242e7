// SPDX-License-Identifier: MIT
// Point light: intensity / distance^2. Parameters: position x y z, intensity r g b (W/sr).

FN LANED(LightSample)
    LANED(point_sample)(const Scene* scene, GLOBAL const int* row, real3w from, LANED(LightNumbers) numbers) {
  GLOBAL const real* params = scene->shading + row[LIGHT_REALS];
  (void)numbers;
  LANED(LightSample) s = LANED(no_light)();
  s.towards = sub3_w(splat3_w(load3(params)), from);
  s.t_max = splat_w(R(1.0));
  realw inverse = splat_w(R(1.0)) / length3_w(s.towards);
  s.radiance = scale3_w(inverse, scale3_w(inverse, splat3_w(load3(params + 3))));
  s.is_delta = ~none_w();
  return s;
}

FN realw LANED(point_density)(const Scene* scene, GLOBAL const int* row, real3w from, real3w towards,
                              const LANED(Surfaces) * s) {
  (void)scene;
  (void)row;
  (void)from;
  (void)towards;
  (void)s;
  return splat_w(R(0.0));
}

FN real3w LANED(point_background)(const Scene* scene, GLOBAL const int* row, real3w towards) {
  (void)scene;
  (void)row;
  (void)towards;
  return splat3_w(vec3(R(0.0), R(0.0), R(0.0)));
}
