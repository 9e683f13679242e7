// SPDX-License-Identifier: MIT
// A rough boundary between two media that absorb nothing: microfacets that reflect and refract. B. Walter and others,
// "Microfacet Models for Refraction through Rough Surfaces", EGSR 2007. Parameters: as dielectric; the microfacets'
// (microfacets_lanes.h).

enum { ROUGHDIELECTRIC_TRANSMITTANCE_w = 3, ROUGHDIELECTRIC_ETA_w = 6, ROUGHDIELECTRIC_FACETS_w = 9 };

FN void roughdielectric_load_w(const Scene* scene, const TexturePlace_w* at, int row, maskw which, Bsdf_w* b) {
  for (int slot = 0; slot < 3; ++slot) put_bsdf_color_w(b, which, 3 * slot, parameter_of_w(scene, at, row, slot));
  microfacets_load_w(scene, at, row, which, 3, b, ROUGHDIELECTRIC_FACETS_w);
}

/// Index of refraction on the far side over that on the side of wo.
FN realw roughdielectric_eta_w(const Bsdf_w* b) {
  realw eta = b->p[ROUGHDIELECTRIC_ETA_w];
  return sel_w(lt_w(b->wo.z, splat_w(R(0.0))), splat_w(R(1.0)) / eta, eta);
}

/// a, turned so that it is on the upper side where wo is.
FN real3w roughdielectric_upright_w(const Bsdf_w* b, real3w a) {
  return sel3_w(lt_w(b->wo.z, splat_w(R(0.0))), negate3_w(a), a);
}

SELDOM_FN real3w roughdielectric_eval_w(const Bsdf_w* b, real3w wi, PRIVATE realw* density) {
  realw zero = splat_w(R(0.0)), one = splat_w(R(1.0)), quarter = splat_w(R(0.25)), eta = roughdielectric_eta_w(b);
  Microfacets_w f = microfacets_of_w(b, ROUGHDIELECTRIC_FACETS_w);
  real3w wo = roughdielectric_upright_w(b, b->wo), in = roughdielectric_upright_w(b, wi);
  maskw is_reflected = lt_w(zero, in.z);
  real3w between = sel3_w(is_reflected, bisector_w(wo, in), fma3_w(eta, in, wo));
  between = sel3_w(lt_w(between.z, zero), negate3_w(between), between);
  real3w m = normalize3_w(between);
  realw cosine = dot3_w(wo, m), far = dot3_w(in, m);
  maskw is_met = lt_w(zero, wo.z) & lt_w(zero, cosine);
  is_met = is_met & ((is_reflected & lt_w(zero, far)) | (lt_w(in.z, zero) & lt_w(far, zero)));
  realw reflectance = fresnel_w(min_w(cosine, one), eta).reflectance;
  realw normals = facets_normals_w(&f, m), drawn = facets_density_w(&f, wo, m, normals, cosine);
  // Solid angle of normals over that of directions, over the cosine; the cosine cancels where it is reflected.
  realw length2 = dot3_w(between, between), narrow = cosine * abs_w(far) / sel_w(is_met, length2, one);
  realw spread = sel_w(is_reflected, quarter * reflectance, (one - reflectance) * narrow);
  *density = sel_w(is_met, drawn * sel_w(is_reflected, spread, eta * eta * spread), zero);
  realw seen = facets_masking_w(&f, wo) * facets_masking_w(&f, in) * abs_w(in.z);
  real3w color = sel3_w(is_reflected, bsdf_color_w(b, 0), bsdf_color_w(b, ROUGHDIELECTRIC_TRANSMITTANCE_w));
  return sel3_w(is_met, scale3_w(normals * seen * spread, color), black_w());
}

SELDOM_FN BsdfSample_w roughdielectric_sample_w(const Bsdf_w* b, int lobes, realw number, realw u, realw v) {
  BsdfSample_w s = no_way_w(b);
  realw zero = splat_w(R(0.0)), one = splat_w(R(1.0)), quarter = splat_w(R(0.25)), eta = roughdielectric_eta_w(b);
  realw inverse = one / eta;
  Microfacets_w f = microfacets_of_w(b, ROUGHDIELECTRIC_FACETS_w);
  real3w wo = roughdielectric_upright_w(b, b->wo), m = facets_draw_w(&f, wo, u, v);
  realw cosine = dot3_w(wo, m);
  Fresnel_w fresnel = fresnel_w(min_w(max_w(cosine, zero), one), eta);
  int is_either = (lobes & LOBE_SIDES) == LOBE_SIDES;
  maskw is_reflected = lt_w(number, fresnel.reflectance);
  if (!is_either) is_reflected = (lobes & LOBE_REFLECT) != 0 ? ~none_w() : none_w();
  realw chance = sel_w(is_reflected, fresnel.reflectance, one - fresnel.reflectance);
  real3w through = normalize3_w(fma3_w(fma_w(inverse, cosine, -fresnel.cosine), m, scale3_w(-inverse, wo)));
  real3w in = sel3_w(is_reflected, facets_mirror_w(wo, m, cosine), through);
  maskw is_side = (is_reflected & lt_w(zero, in.z)) | (~is_reflected & lt_w(in.z, zero));
  maskw is_met = lt_w(zero, wo.z) & lt_w(zero, cosine) & lt_w(zero, chance) & is_side;
  realw normals = facets_normals_w(&f, m), drawn = facets_density_w(&f, wo, m, one, cosine);
  realw share = facets_masking_w(&f, wo) * facets_masking_w(&f, in) * abs_w(in.z) / drawn;
  real3w color = sel3_w(is_reflected, bsdf_color_w(b, 0),
                        scale3_w(inverse * inverse, bsdf_color_w(b, ROUGHDIELECTRIC_TRANSMITTANCE_w)));
  s.weight = sel3_w(is_met, scale3_w(is_either ? share : share * chance, color), black_w());
  // eta cos_t - cos_i = (eta^2 - 1) / (eta cos_t + cos_i): the half vector's length without cancellation.
  realw sum = fma_w(eta, fresnel.cosine, cosine), length = (eta - one) * (eta + one) / sel_w(is_met, sum, one);
  realw narrow = eta * eta * cosine * fresnel.cosine / (length * length);
  realw density = normals * drawn * sel_w(is_reflected, quarter, narrow);
  s.density = sel_w(is_met, is_either ? chance * density : density, zero);
  s.eta = sel_w(is_reflected, one, eta);
  intw side =
      sel_int_w(is_reflected, splat_int_w(LOBE_GLOSSY | LOBE_REFLECT), splat_int_w(LOBE_GLOSSY | LOBE_TRANSMIT));
  s.lobe = side;
  s.wi = roughdielectric_upright_w(b, in);
  return s;
}
