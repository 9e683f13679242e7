// SPDX-License-Identifier: MIT
// Lambertian reflection, f = rho / pi. Parameters: rho r g b.

FN void LANED(diffuse_load)(const Scene* scene, const LANED(Surfaces) * s, intw rows, maskw which, LANED(Bsdf) * b) {
  LANED(put_bsdf_color)(b, which, 0, LANED(parameter_at)(scene, s, which, rows, 0));
}

FN real3w LANED(diffuse_eval)(const LANED(Bsdf) * b, real3w wi, PRIVATE realw* density) {
  realw zero = splat_w(R(0.0));
  *density = sel_w(lt_w(zero, wi.z) & lt_w(zero, b->wo.z), wi.z * splat_w(ONE_OVER_PI), zero);
  return scale3_w(*density, LANED(bsdf_color)(b, 0));
}

FN LANED(BsdfSample) LANED(diffuse_sample)(const LANED(Bsdf) * b, int lobes, realw number, realw u, realw v) {
  (void)lobes;
  (void)number;
  LANED(BsdfSample) s = LANED(no_way)(b);
  s.wi = LANED(square_to_cosine_hemisphere)(u, v);
  s.weight = sel3_w(lt_w(splat_w(R(0.0)), b->wo.z), LANED(bsdf_color)(b, 0), LANED(black)());
  s.density = s.wi.z * splat_w(ONE_OVER_PI);
  s.lobe = splat_int_w(LOBE_DIFFUSE | LOBE_REFLECT);
  return s;
}
