// SPDX-License-Identifier: MIT
// Ideal mirror: the same share of the light at every angle. Parameters: specular reflectance r g b.

FN void LANED(conductor_load)(const Scene* scene, const LANED(Surfaces) * s, intw rows, maskw which, LANED(Bsdf) * b) {
  LANED(put_bsdf_color)(b, which, 0, LANED(parameter_at)(scene, s, which, rows, 0));
}

FN real3w LANED(conductor_eval)(const LANED(Bsdf) * b, real3w wi, PRIVATE realw* density) {
  (void)b;
  (void)wi;
  *density = splat_w(R(0.0));
  return LANED(black)();
}

FN LANED(BsdfSample) LANED(conductor_sample)(const LANED(Bsdf) * b, int lobes, realw number, realw u, realw v) {
  (void)lobes;
  (void)number;
  (void)u;
  (void)v;
  LANED(BsdfSample) s = LANED(no_way)(b);
  s.wi = vec3_w(-b->wo.x, -b->wo.y, b->wo.z);
  s.weight = sel3_w(lt_w(splat_w(R(0.0)), b->wo.z), LANED(bsdf_color)(b, 0), LANED(black)());
  s.density = splat_w(R(1.0));
  s.lobe = splat_int_w(LOBE_DELTA | LOBE_REFLECT);
  return s;
}
