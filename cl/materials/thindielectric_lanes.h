// SPDX-License-Identifier: MIT
// A pane of smooth glass as one surface: what is reflected between its two faces is summed, R + (1 - R)^2 R / (1 - R^2)
// = 2 R / (1 + R); the rest goes through straight. Parameters: specular reflectance r g b, specular transmittance r g
// b, index of refraction inside over outside.

enum { THINDIELECTRIC_TRANSMITTANCE_w = 3, THINDIELECTRIC_ETA_w = 6 };

/// The share that is reflected of light at that cosine. through: the share that goes through.
FN realw pane_reflectance_w(realw cosine, realw eta, PRIVATE realw* through) {
  realw one = splat_w(R(1.0)), once = fresnel_w(cosine, eta).reflectance;
  *through = (one - once) / (one + once);
  return splat_w(R(2.0)) * once / (one + once);
}

FN void thindielectric_load_w(const Scene* scene, const TexturePlace_w* at, int row, maskw which, Bsdf_w* b) {
  for (int slot = 0; slot < 3; ++slot) put_bsdf_color_w(b, which, 3 * slot, parameter_of_w(scene, at, row, slot));
}

FN real3w thindielectric_eval_w(const Bsdf_w* b, real3w wi, PRIVATE realw* density) {
  (void)b;
  (void)wi;
  *density = splat_w(R(0.0));
  return black_w();
}

FN BsdfSample_w thindielectric_sample_w(const Bsdf_w* b, int lobes, realw number, realw u, realw v) {
  (void)u;
  (void)v;
  BsdfSample_w s = no_way_w(b);
  realw one = splat_w(R(1.0)), transmittance;
  realw reflectance = pane_reflectance_w(abs_w(b->wo.z), b->p[THINDIELECTRIC_ETA_w], &transmittance);
  int is_either = (lobes & LOBE_SIDES) == LOBE_SIDES;
  maskw is_reflected = lt_w(number, reflectance);
  if (HAS_PANE) is_reflected = is_reflected | b->reflects;
  if (!is_either) is_reflected = (lobes & LOBE_REFLECT) != 0 ? ~none_w() : none_w();
  realw chance = sel_w(is_reflected, reflectance, transmittance);
  s.weight = sel3_w(is_reflected, bsdf_color_w(b, 0), bsdf_color_w(b, THINDIELECTRIC_TRANSMITTANCE_w));
  if (!is_either) s.weight = scale3_w(chance, s.weight);
  s.density = is_either ? chance : one;
  s.lobe = sel_int_w(is_reflected, splat_int_w(LOBE_DELTA | LOBE_REFLECT), splat_int_w(LOBE_DELTA | LOBE_TRANSMIT));
  s.wi = sel3_w(is_reflected, vec3_w(-b->wo.x, -b->wo.y, b->wo.z), negate3_w(b->wo));
  return s;
}
