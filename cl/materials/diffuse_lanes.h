// SPDX-License-Identifier: MIT
// Lambertian reflection, f = rho / pi. Parameters: rho r g b.

FN void diffuse_load_w(const Scene* scene, const TexturePlace_w* at, int row, maskw which, Bsdf_w* b) {
  put_bsdf_color_w(b, which, 0, parameter_of_w(scene, at, row, 0));
}

FN real3w diffuse_eval_w(const Bsdf_w* b, real3w wi, PRIVATE realw* density) {
  realw zero = splat_w(R(0.0));
  *density = sel_w(lt_w(zero, wi.z) & lt_w(zero, b->wo.z), wi.z * splat_w(ONE_OVER_PI), zero);
  return scale3_w(*density, bsdf_color_w(b, 0));
}

FN BsdfSample_w diffuse_sample_w(const Bsdf_w* b, int lobes, realw number, realw u, realw v) {
  (void)lobes;
  (void)number;
  BsdfSample_w s = no_way_w(b);
  s.wi = square_to_cosine_hemisphere_w(u, v);
  s.weight = sel3_w(lt_w(splat_w(R(0.0)), b->wo.z), bsdf_color_w(b, 0), black_w());
  s.density = s.wi.z * splat_w(ONE_OVER_PI);
  s.lobe = splat_int_w(LOBE_DIFFUSE | LOBE_REFLECT);
  return s;
}
