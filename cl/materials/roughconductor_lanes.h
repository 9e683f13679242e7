// SPDX-License-Identifier: MIT
// Metal of microfacets, seen from its front. Parameters: specular reflectance r g b; eta r g b, k r g b, the index of
// refraction over that outside; the microfacets' (microfacets_lanes.h).

enum { ROUGHCONDUCTOR_ETA_w = 3, ROUGHCONDUCTOR_K_w = 6, ROUGHCONDUCTOR_FACETS_w = 9 };

FN void roughconductor_load_w(const Scene* scene, const TexturePlace_w* at, int row, maskw which, Bsdf_w* b) {
  for (int slot = 0; slot < 3; ++slot) put_bsdf_color_w(b, which, 3 * slot, parameter_of_w(scene, at, row, slot));
  microfacets_load_w(scene, at, row, which, 3, b, ROUGHCONDUCTOR_FACETS_w);
}

FN real3w roughconductor_reflectance_w(const Bsdf_w* b, realw cosine) {
  realw one = splat_w(R(1.0));
  return mul3_w(bsdf_color_w(b, 0),
                metal_reflectances_w(sel_w(lt_w(cosine, one), cosine, one), bsdf_color_w(b, ROUGHCONDUCTOR_ETA_w),
                                     bsdf_color_w(b, ROUGHCONDUCTOR_K_w)));
}

SELDOM_FN real3w roughconductor_eval_w(const Bsdf_w* b, real3w wi, PRIVATE realw* density) {
  realw zero = splat_w(R(0.0)), quarter = splat_w(R(0.25));
  Microfacets_w f = microfacets_of_w(b, ROUGHCONDUCTOR_FACETS_w);
  real3w m = normalize3_w(bisector_w(b->wo, wi));
  realw cosine = dot3_w(b->wo, m);
  maskw is_lit = lt_w(zero, wi.z) & lt_w(zero, b->wo.z) & lt_w(zero, cosine);
  realw normals = facets_normals_w(&f, m);
  *density = sel_w(is_lit, quarter * facets_density_w(&f, b->wo, m, normals, cosine), zero);
  realw seen = facets_masking_w(&f, b->wo) * facets_masking_w(&f, wi) * wi.z;
  return sel3_w(is_lit, scale3_w(quarter * normals * seen, roughconductor_reflectance_w(b, cosine)), black_w());
}

SELDOM_FN BsdfSample_w roughconductor_sample_w(const Bsdf_w* b, int lobes, realw number, realw u, realw v) {
  (void)lobes;
  (void)number;
  BsdfSample_w s = no_way_w(b);
  realw zero = splat_w(R(0.0));
  Microfacets_w f = microfacets_of_w(b, ROUGHCONDUCTOR_FACETS_w);
  real3w wo = vec3_w(b->wo.x, b->wo.y, abs_w(b->wo.z)), m = facets_draw_w(&f, wo, u, v);
  realw cosine = dot3_w(wo, m);
  s.wi = facets_mirror_w(wo, m, cosine);
  maskw is_lit = lt_w(zero, s.wi.z) & lt_w(zero, b->wo.z) & lt_w(zero, cosine);
  realw normals = facets_normals_w(&f, m);
  realw drawn = facets_density_w(&f, wo, m, splat_w(R(1.0)), cosine);
  realw share = facets_masking_w(&f, wo) * facets_masking_w(&f, s.wi) * s.wi.z / drawn;
  s.weight = sel3_w(is_lit, scale3_w(share, roughconductor_reflectance_w(b, cosine)), black_w());
  s.density = sel_w(is_lit, splat_w(R(0.25)) * normals * drawn, zero);
  s.lobe = splat_int_w(LOBE_GLOSSY | LOBE_REFLECT);
  return s;
}
