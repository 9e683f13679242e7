// SPDX-License-Identifier: MIT
// Ideal mirror: the same share of the light at every angle. Parameters: specular reflectance r g b.

FN void conductor_load_w(const Scene* scene, const Surfaces_w* s, intw rows, maskw which, Bsdf_w* b) {
  put_bsdf_color_w(b, which, 0, parameter_at_w(scene, s, which, rows, 0));
}

FN real3w conductor_eval_w(const Bsdf_w* b, real3w wi, PRIVATE realw* density) {
  (void)b;
  (void)wi;
  *density = splat_w(R(0.0));
  return black_w();
}

FN BsdfSample_w conductor_sample_w(const Bsdf_w* b, int lobes, realw number, realw u, realw v) {
  (void)lobes;
  (void)number;
  (void)u;
  (void)v;
  BsdfSample_w s = no_way_w(b);
  s.wi = vec3_w(-b->wo.x, -b->wo.y, b->wo.z);
  s.weight = sel3_w(lt_w(splat_w(R(0.0)), b->wo.z), bsdf_color_w(b, 0), black_w());
  s.density = splat_w(R(1.0));
  s.lobe = splat_int_w(LOBE_DELTA | LOBE_REFLECT);
  return s;
}
