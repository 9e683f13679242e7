// SPDX-License-Identifier: MIT
// A diffuse base, rough metal and rough glass in any proportion under a clear coat, with sheen: B. Burley, "Physically
// Based Shading at Disney", SIGGRAPH 2012 courses, and "Extending the Disney BRDF to a BSDF with Integrated Subsurface
// Scattering", SIGGRAPH 2015 courses, as Mitsuba has them. Sheen and the clear coat are added, so a white one may
// reflect more than it receives (docs/scene-materials.md). Parameters: a slot each, base colour r g b; roughness,
// anisotropic, metallic, spec_trans, spec_tint, sheen, sheen_tint, flatness, clearcoat, clearcoat_gloss in the first
// real; index of refraction inside over outside; how often the main specular lobe, the clear coat and the base are
// drawn.

enum {
  PRINCIPLED_ROUGHNESS_w = 3,
  PRINCIPLED_ANISOTROPIC_w = 6,
  PRINCIPLED_METALLIC_w = 9,
  PRINCIPLED_SPEC_TRANS_w = 12,
  PRINCIPLED_SPEC_TINT_w = 15,
  PRINCIPLED_SHEEN_w = 18,
  PRINCIPLED_SHEEN_TINT_w = 21,
  PRINCIPLED_FLATNESS_w = 24,
  PRINCIPLED_CLEARCOAT_w = 27,
  PRINCIPLED_GLOSS_w = 30,
  PRINCIPLED_ETA_w = 33,
  PRINCIPLED_RATES_w = 36,
  PRINCIPLED_SLOTS_w = 13
};

FN void principled_load_w(const Scene* scene, const TexturePlace_w* at, int row, maskw which, Bsdf_w* b) {
  for (int slot = 0; slot < PRINCIPLED_SLOTS_w; ++slot) {
    real3w value = parameter_of_w(scene, at, row, slot);
    int is_number = slot > 0 && slot < PRINCIPLED_ETA_w / 3;
    if (is_number) value.x = luminance_w(value);
    put_bsdf_color_w(b, which, 3 * slot, value);
  }
}

/// Shares of the base and of glass; the rest is metal. The index of refraction on the far side over that of wo, and the
/// chances of the lobes: of the base, of the clear coat, and of both and the main specular lobe, which is 1.
typedef struct {
  realw base, glass, eta, diffuse, coated, coat_alpha;
  maskw is_front;
  Microfacets_w facets;
} Principled_w;

FN Principled_w principled_of_w(const Bsdf_w* b) {
  Principled_w p;
  realw zero = splat_w(R(0.0)), one = splat_w(R(1.0));
  realw dielectric = one - b->p[PRINCIPLED_METALLIC_w], trans = b->p[PRINCIPLED_SPEC_TRANS_w];
  p.is_front = lt_w(zero, b->wo.z);
  p.base = sel_w(p.is_front, dielectric * (one - trans), zero);
  p.glass = dielectric * trans;
  p.eta = sel_w(p.is_front, b->p[PRINCIPLED_ETA_w], one / b->p[PRINCIPLED_ETA_w]);
  p.facets = disney_facets_w(b->p[PRINCIPLED_ROUGHNESS_w], b->p[PRINCIPLED_ANISOTROPIC_w]);
  p.coat_alpha = fma_w(splat_w(R(-0.099)), b->p[PRINCIPLED_GLOSS_w], splat_w(R(0.1)));
  realw specular = b->p[PRINCIPLED_RATES_w];
  realw coat = splat_w(R(0.25)) * b->p[PRINCIPLED_CLEARCOAT_w] * b->p[PRINCIPLED_RATES_w + 1];
  realw diffuse = p.base * b->p[PRINCIPLED_RATES_w + 2], all = specular + coat + diffuse;
  maskw is_divided = p.is_front & lt_w(zero, all);
  realw divisor = sel_w(is_divided, all, one);
  p.diffuse = sel_w(is_divided, diffuse / divisor, zero);
  p.coated = sel_w(is_divided, coat / divisor, zero);
  return p;
}

/// What a microfacet reflects of light that meets it at that cosine. As Mitsuba: metal and tint too are black where the
/// dielectric reflects nothing, which an index of 1 does at every angle.
FN real3w principled_reflectance_w(const Bsdf_w* b, const Principled_w* p, realw cosine, Fresnel_w f) {
  realw one = splat_w(R(1.0)), metallic = b->p[PRINCIPLED_METALLIC_w], tint = b->p[PRINCIPLED_SPEC_TINT_w];
  realw plain = (one - metallic) * (one - tint) * f.reflectance;
  realw weight = schlick_weight_w(sel_w(lt_w(one, p->eta), cosine, f.cosine));
  real3w color = bsdf_color_w(b, 0), tinted = disney_tinted_f0_w(color, p->eta), front = vec3_w(plain, plain, plain);
  front = fma3_w(metallic, schlick3_w(color, weight), front);
  front = fma3_w((one - metallic) * tint, schlick3_w(tinted, weight), front);
  realw back = p->glass * f.reflectance;
  maskw reflects = lt_w(splat_w(R(0.0)), f.reflectance);
  return sel3_w(reflects, sel3_w(p->is_front, front, vec3_w(back, back, back)), black_w());
}

/// The share of the main specular lobe's draws that are reflected at a microfacet.
FN realw principled_reflected_w(const Principled_w* p, Fresnel_w f) {
  realw one = splat_w(R(1.0));
  return sel_w(p->is_front, fma_w(-p->glass, one - f.reflectance, one), f.reflectance);
}

/// The base, f times the cosine of wi: diffuse, retro-reflection or its flat look, and sheen. cosine: of wi and the
/// half vector.
FN real3w principled_base_w(const Bsdf_w* b, const Principled_w* p, realw in, realw cosine) {
  realw one = splat_w(R(1.0)), rough = b->p[PRINCIPLED_ROUGHNESS_w];
  realw diffuse = disney_diffuse_w(rough, b->p[PRINCIPLED_FLATNESS_w], b->wo.z, in, cosine);
  realw sheen = b->p[PRINCIPLED_SHEEN_w] * (one - b->p[PRINCIPLED_METALLIC_w]) * schlick_weight_w(cosine);
  real3w color = bsdf_color_w(b, 0), tint = disney_sheen_color_w(color, b->p[PRINCIPLED_SHEEN_TINT_w]);
  real3w all = fma3_w(p->base * diffuse * splat_w(ONE_OVER_PI), color, scale3_w(sheen, tint));
  return scale3_w(in, all);
}

/// The clear coat, f times the cosine of wi.
FN realw principled_coat_w(const Bsdf_w* b, const Principled_w* p, real3w in, real3w m, realw cosine, Fresnel_w f) {
  realw weight = schlick_weight_w(sel_w(lt_w(splat_w(R(1.0)), p->eta), cosine, f.cosine));
  realw fresnel = fma_w(splat_w(R(0.96)), weight, splat_w(R(0.04))), quarter = splat_w(R(0.25));
  realw seen = disney_coat_masking_w(b->wo.z) * disney_coat_masking_w(in.z);
  return quarter * b->p[PRINCIPLED_CLEARCOAT_w] * fresnel * gtr1_normals_w(p->coat_alpha, m) * seen * in.z;
}

SELDOM_FN real3w principled_eval_w(const Bsdf_w* b, real3w wi, PRIVATE realw* density) {
  realw zero = splat_w(R(0.0)), one = splat_w(R(1.0)), quarter = splat_w(R(0.25));
  Principled_w p = principled_of_w(b);
  real3w wo = sel3_w(p.is_front, b->wo, negate3_w(b->wo)), in = sel3_w(p.is_front, wi, negate3_w(wi));
  maskw is_reflected = lt_w(zero, in.z);
  real3w between = sel3_w(is_reflected, bisector_w(wo, in), fma3_w(p.eta, in, wo));
  between = sel3_w(lt_w(between.z, zero), negate3_w(between), between);
  real3w m = normalize3_w(between);
  realw cosine = min_w(dot3_w(wo, m), one), far = dot3_w(in, m);
  maskw is_lit = lt_w(zero, wo.z) & (p.is_front | lt_w(zero, p.glass));
  maskw is_met = is_lit & lt_w(zero, cosine);
  is_met = is_met & ((is_reflected & lt_w(zero, far)) | (lt_w(in.z, zero) & lt_w(far, zero)));
  Fresnel_w f = fresnel_w(max_w(cosine, zero), p.eta);
  realw normals = facets_normals_w(&p.facets, m), drawn = facets_density_w(&p.facets, wo, m, normals, cosine);
  realw length2 = dot3_w(between, between), narrow = cosine * abs_w(far) / sel_w(is_met, length2, one);
  realw share = principled_reflected_w(&p, f), rest = one - p.diffuse - p.coated;
  realw seen = normals * facets_masking_w(&p.facets, wo) * facets_masking_w(&p.facets, in) * abs_w(in.z);
  // Of the main specular lobe.
  realw spread = sel_w(is_reflected, quarter * share, p.eta * p.eta * narrow * (one - share));
  realw dense = sel_w(is_met, rest * drawn * spread, zero);
  real3w root = sqrt3_w(bsdf_color_w(b, 0));
  real3w through = scale3_w(p.glass * (one - f.reflectance) * narrow * seen, root);
  real3w reflected = scale3_w(quarter * seen, principled_reflectance_w(b, &p, cosine, f));
  real3w value = sel3_w(is_met, sel3_w(is_reflected, reflected, through), black_w());
  // Above the surface the base and the coat as well.
  maskw is_above = is_lit & p.is_front & is_reflected, is_coated = is_above & is_met;
  real3w base = principled_base_w(b, &p, in.z, abs_w(far));
  value = sel3_w(is_above, add3_w(value, base), value);
  realw coat = principled_coat_w(b, &p, in, m, cosine, f);
  value = sel3_w(is_coated, add3_w(value, vec3_w(coat, coat, coat)), value);
  realw coat_density = gtr1_normals_w(p.coat_alpha, m) * m.z * quarter / sel_w(is_met, cosine, one);
  dense = sel_w(is_above, fma_w(p.diffuse * splat_w(ONE_OVER_PI), in.z, dense), dense);
  *density = sel_w(is_coated, fma_w(p.coated, coat_density, dense), dense);
  return value;
}

SELDOM_FN BsdfSample_w principled_sample_w(const Bsdf_w* b, int lobes, realw number, realw u, realw v) {
  (void)lobes;
  BsdfSample_w s = no_way_w(b);
  realw zero = splat_w(R(0.0)), one = splat_w(R(1.0));
  Principled_w p = principled_of_w(b);
  real3w wo = sel3_w(p.is_front, b->wo, negate3_w(b->wo));
  realw others = p.diffuse + p.coated;
  maskw is_diffuse = lt_w(number, p.diffuse), is_coat = ~is_diffuse & lt_w(number, others);
  maskw is_specular = ~is_diffuse & ~is_coat;
  real3w m = facets_draw_w(&p.facets, wo, u, v);
  m = sel3_w(is_coat, gtr1_draw_w(p.coat_alpha, u, v), m);
  realw cosine = dot3_w(wo, m);
  Fresnel_w f = fresnel_w(min_w(max_w(cosine, zero), one), p.eta);
  realw left = (number - others) / sel_w(lt_w(others, one), one - others, one);
  maskw is_through = is_specular & ~lt_w(left, principled_reflected_w(&p, f));
  realw inverse = one / p.eta;
  real3w through = normalize3_w(fma3_w(fma_w(inverse, cosine, -f.cosine), m, scale3_w(-inverse, wo)));
  real3w in = sel3_w(is_through, through, facets_mirror_w(wo, m, cosine));
  in = sel3_w(is_diffuse, square_to_cosine_hemisphere_w(u, v), in);
  s.wi = sel3_w(p.is_front, in, negate3_w(in));
  real3w value = principled_eval_w(b, s.wi, &s.density);
  maskw is_side = (is_through & lt_w(in.z, zero)) | (~is_through & lt_w(zero, in.z));
  maskw is_drawn = is_side & lt_w(zero, s.density) & (is_diffuse | lt_w(zero, cosine));
  s.density = sel_w(is_drawn, s.density, zero);
  s.weight = sel3_w(is_drawn, scale3_w(one / sel_w(is_drawn, s.density, one), value), black_w());
  s.eta = sel_w(is_through, p.eta, one);
  intw spread = sel_int_w(is_diffuse, splat_int_w(LOBE_DIFFUSE), splat_int_w(LOBE_GLOSSY));
  s.lobe = spread | sel_int_w(is_through, splat_int_w(LOBE_TRANSMIT), splat_int_w(LOBE_REFLECT));
  return s;
}
