// SPDX-License-Identifier: MIT
// A sheet that scatters light to the other side only, alike from both sides: f = T / pi, as Mitsuba 0.x has it.
// Parameters: T r g b.

FN void difftrans_load_w(const Scene* scene, const TexturePlace_w* at, int row, maskw which, Bsdf_w* b) {
  put_bsdf_color_w(b, which, 0, parameter_of_w(scene, at, row, 0));
}

FN real3w difftrans_eval_w(const Bsdf_w* b, real3w wi, PRIVATE realw* density) {
  realw zero = splat_w(R(0.0));
  *density = sel_w(lt_w(wi.z * b->wo.z, zero), abs_w(wi.z) * splat_w(ONE_OVER_PI), zero);
  return scale3_w(*density, bsdf_color_w(b, 0));
}

FN BsdfSample_w difftrans_sample_w(const Bsdf_w* b, int lobes, realw number, realw u, realw v) {
  (void)lobes;
  (void)number;
  BsdfSample_w s = no_way_w(b);
  s.wi = square_to_cosine_hemisphere_w(u, v);
  s.density = s.wi.z * splat_w(ONE_OVER_PI);
  s.wi.z = sel_w(lt_w(b->wo.z, splat_w(R(0.0))), s.wi.z, -s.wi.z);
  s.weight = bsdf_color_w(b, 0);
  s.lobe = splat_int_w(LOBE_DIFFUSE | LOBE_TRANSMIT);
  return s;
}
