// SPDX-License-Identifier: MIT
// Open cylinder: foot, axis (as long as it is), two perpendicular radii.

FN LANED(AreaPoint)
    LANED(cylinder_point)(GLOBAL const real* item, GLOBAL const real* area, real3w from, realw u, realw v) {
  LANED(SinCos) turned = LANED(sincos_turns)(u);
  real3w outward = fma3_w(turned.cosine, splat3_w(load3(item + 6)), scale3_w(turned.sine, splat3_w(load3(item + 9))));
  real3w position = add3_w(fma3_w(v, splat3_w(load3(item + 3)), outward), splat3_w(load3(item)));
  return LANED(uniform_point)(area, from, position, normalize3_w(scale3_w(splat_w(area[AREA_SIDE]), outward)));
}

FN realw LANED(cylinder_density)(GLOBAL const real* item, GLOBAL const real* area, real3w from, real3w towards,
                                 real3w normal) {
  (void)item;
  (void)from;
  return LANED(uniform_density)(area, towards, normal);
}
