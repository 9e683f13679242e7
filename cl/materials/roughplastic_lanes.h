// SPDX-License-Identifier: MIT
// As plastic, under a boundary of microfacets. The share of light that goes through the boundary towards the base and
// out of it is a polynomial, which the host fits (src/kinds/rough_boundary.cpp; its variable: rough_boundary.h).
// Parameters: diffuse reflectance r g b, specular reflectance r g b; the base's (base_lanes.h), and how soft its
// variable is; the microfacets' (microfacets_lanes.h), and the variable's spread; the polynomial's.

enum {
  ROUGHPLASTIC_SPECULAR_w = 3,
  ROUGHPLASTIC_BASE_w = 6,
  ROUGHPLASTIC_ETA_w = 6,
  ROUGHPLASTIC_INVERSE2_w = 10,
  ROUGHPLASTIC_SOFT_w = 11,
  ROUGHPLASTIC_FACETS_w = 12,
  ROUGHPLASTIC_SPREAD_w = 20,
  ROUGHPLASTIC_THROUGH_w = 21
};
enum { ROUGHPLASTIC_TERMS_w = 9 };

FN void roughplastic_load_w(const Scene* scene, const TexturePlace_w* at, int row, maskw which, Bsdf_w* b) {
  for (int slot = 0; slot < 10; ++slot) put_bsdf_color_w(b, which, 3 * slot, parameter_of_w(scene, at, row, slot));
}

/// The share that goes through at that cosine.
FN realw roughplastic_through_w(const Bsdf_w* b, realw cosine) {
  realw zero = splat_w(R(0.0)), one = splat_w(R(1.0)), two = splat_w(R(2.0)), y = cosine;
  realw soft = b->p[ROUGHPLASTIC_SOFT_w], spread = b->p[ROUGHPLASTIC_SPREAD_w];
  maskw is_thinner = lt_w(zero, soft);
  if (any_w(is_thinner)) {
    realw q = fma_w((cosine - one) * (cosine + one), b->p[ROUGHPLASTIC_INVERSE2_w], one), size = abs_w(q);
    realw larger = sqrt_w(splat_w(R(0.5)) * (size + sqrt_w(fma_w(q, q, soft * soft))));
    y = sel_w(is_thinner, sel_w(lt_w(q, zero), soft / (two * sel_w(is_thinner, larger, one)), larger), y);
  }
  realw x = fma_w(fma_w(two, spread, one), y, -spread) / (y + spread);
  realw sum = b->p[ROUGHPLASTIC_THROUGH_w];
  for (int k = 1; k < ROUGHPLASTIC_TERMS_w; ++k) sum = fma_w(sum, x, b->p[ROUGHPLASTIC_THROUGH_w + k]);
  return min_w(max_w(sum, zero), one);
}

SELDOM_FN real3w roughplastic_eval_w(const Bsdf_w* b, real3w wi, PRIVATE realw* density) {
  realw zero = splat_w(R(0.0)), one = splat_w(R(1.0)), quarter = splat_w(R(0.25));
  Microfacets_w f = microfacets_of_w(b, ROUGHPLASTIC_FACETS_w);
  real3w m = normalize3_w(bisector_w(b->wo, wi));
  realw cosine = dot3_w(b->wo, m), lambert = wi.z * splat_w(ONE_OVER_PI);
  maskw is_lit = lt_w(zero, wi.z) & lt_w(zero, b->wo.z), is_met = is_lit & lt_w(zero, cosine);
  realw out = roughplastic_through_w(b, b->wo.z), in = roughplastic_through_w(b, wi.z);
  realw rest = base_chance_w(b, ROUGHPLASTIC_BASE_w, out), normals = facets_normals_w(&f, m);
  realw drawn = sel_w(is_met, quarter * facets_density_w(&f, b->wo, m, normals, cosine), zero);
  *density = sel_w(is_lit, fma_w(one - rest, drawn, rest * lambert), zero);
  realw eta = b->p[ROUGHPLASTIC_ETA_w], seen = facets_masking_w(&f, b->wo) * facets_masking_w(&f, wi);
  realw reflected = fresnel_w(min_w(max_w(cosine, zero), one), eta).reflectance * quarter * normals * seen * wi.z;
  real3w specular = scale3_w(sel_w(is_met, reflected, zero), bsdf_color_w(b, ROUGHPLASTIC_SPECULAR_w));
  return sel3_w(is_lit, fma3_w(lambert * out * in, base_color_w(b, ROUGHPLASTIC_BASE_w), specular), black_w());
}

SELDOM_FN BsdfSample_w roughplastic_sample_w(const Bsdf_w* b, int lobes, realw number, realw u, realw v) {
  (void)lobes;
  BsdfSample_w s = no_way_w(b);
  realw zero = splat_w(R(0.0)), one = splat_w(R(1.0));
  Microfacets_w f = microfacets_of_w(b, ROUGHPLASTIC_FACETS_w);
  realw out = roughplastic_through_w(b, max_w(b->wo.z, zero));
  maskw is_specular = lt_w(number, one - base_chance_w(b, ROUGHPLASTIC_BASE_w, out));
  real3w wo = vec3_w(b->wo.x, b->wo.y, abs_w(b->wo.z)), m = facets_draw_w(&f, wo, u, v);
  s.wi = sel3_w(is_specular, facets_mirror_w(wo, m, dot3_w(wo, m)), square_to_cosine_hemisphere_w(u, v));
  real3w value = roughplastic_eval_w(b, s.wi, &s.density);
  maskw is_drawn = lt_w(zero, s.density);
  s.weight = sel3_w(is_drawn, scale3_w(one / sel_w(is_drawn, s.density, one), value), black_w());
  s.lobe = sel_int_w(is_specular, splat_int_w(LOBE_GLOSSY | LOBE_REFLECT), splat_int_w(LOBE_DIFFUSE | LOBE_REFLECT));
  return s;
}
