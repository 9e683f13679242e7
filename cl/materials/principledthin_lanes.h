// SPDX-License-Identifier: MIT
// As principled, of a sheet: glass that does not bend light, and a base that lets light through, alike from both sides.
// B. Burley, "Extending the Disney BRDF to a BSDF with Integrated Subsurface Scattering", SIGGRAPH 2015 courses, as
// Mitsuba has it. Parameters: a slot each, base colour r g b; roughness, anisotropic, spec_trans, spec_tint, sheen,
// sheen_tint, flatness, diff_trans (0 to 2), eta in the first real; how often what the glass reflects, what it
// transmits and what the base reflects is drawn; and what the base transmits.

enum {
  PRINCIPLEDTHIN_ROUGHNESS_w = 3,
  PRINCIPLEDTHIN_ANISOTROPIC_w = 6,
  PRINCIPLEDTHIN_SPEC_TRANS_w = 9,
  PRINCIPLEDTHIN_SPEC_TINT_w = 12,
  PRINCIPLEDTHIN_SHEEN_w = 15,
  PRINCIPLEDTHIN_SHEEN_TINT_w = 18,
  PRINCIPLEDTHIN_FLATNESS_w = 21,
  PRINCIPLEDTHIN_DIFF_TRANS_w = 24,
  PRINCIPLEDTHIN_ETA_w = 27,
  PRINCIPLEDTHIN_RATES_w = 30,
  PRINCIPLEDTHIN_SLOTS_w = 12
};

FN void principledthin_load_w(const Scene* scene, const TexturePlace_w* at, int row, maskw which, Bsdf_w* b) {
  for (int slot = 0; slot < PRINCIPLEDTHIN_SLOTS_w; ++slot) {
    real3w value = parameter_of_w(scene, at, row, slot);
    int is_number = slot > 0 && slot < PRINCIPLEDTHIN_RATES_w / 3;
    if (is_number) value.x = luminance_w(value);
    put_bsdf_color_w(b, which, 3 * slot, value);
  }
}

/// Shares of light that the base reflects and transmits, the microfacets of what the glass reflects and transmits, and
/// the chances of the four lobes.
typedef struct {
  realw reflecting, transmitting;
  realw glass_reflects, glass_transmits, base_reflects, base_transmits;
  Microfacets_w above, through;
} PrincipledThin_w;

FN PrincipledThin_w principledthin_of_w(const Bsdf_w* b) {
  PrincipledThin_w p;
  realw zero = splat_w(R(0.0)), one = splat_w(R(1.0)), half_one = splat_w(R(0.5));
  // A texture of floats may give more than 2.
  realw trans = b->p[PRINCIPLEDTHIN_SPEC_TRANS_w], behind = min_w(half_one * b->p[PRINCIPLEDTHIN_DIFF_TRANS_w], one);
  realw rough = b->p[PRINCIPLEDTHIN_ROUGHNESS_w], anisotropic = b->p[PRINCIPLEDTHIN_ANISOTROPIC_w];
  p.reflecting = (one - trans) * (one - behind);
  p.transmitting = (one - trans) * behind;
  p.above = disney_facets_w(rough, anisotropic);
  // Burley 2015, figure 15.
  realw narrower = fma_w(splat_w(R(0.65)), b->p[PRINCIPLEDTHIN_ETA_w], splat_w(R(-0.35)));
  p.through = disney_facets_w(narrower * rough, anisotropic);
  p.glass_reflects = half_one * trans * b->p[PRINCIPLEDTHIN_RATES_w];
  p.glass_transmits = half_one * trans * b->p[PRINCIPLEDTHIN_RATES_w + 1];
  p.base_reflects = p.reflecting * b->p[PRINCIPLEDTHIN_RATES_w + 2];
  p.base_transmits = p.transmitting * b->p[PRINCIPLEDTHIN_RATES_w + 3];
  realw all = (p.glass_reflects + p.glass_transmits) + (p.base_reflects + p.base_transmits);
  realw scale = one / sel_w(lt_w(zero, all), all, one);
  p.glass_reflects = p.glass_reflects * scale;
  p.glass_transmits = p.glass_transmits * scale;
  p.base_reflects = p.base_reflects * scale;
  p.base_transmits = p.base_transmits * scale;
  return p;
}

/// What a microfacet reflects of light that meets it at that cosine.
FN real3w principledthin_reflectance_w(const Bsdf_w* b, realw cosine, Fresnel_w f) {
  realw one = splat_w(R(1.0)), eta = b->p[PRINCIPLEDTHIN_ETA_w], tint = b->p[PRINCIPLEDTHIN_SPEC_TINT_w];
  realw weight = schlick_weight_w(sel_w(lt_w(one, eta), cosine, f.cosine)), plain = (one - tint) * f.reflectance;
  real3w tinted = schlick3_w(disney_tinted_f0_w(bsdf_color_w(b, 0), eta), weight);
  return fma3_w(tint, tinted, vec3_w(plain, plain, plain));
}

/// A density of directions over the microfacets of one side. in: on the side of wo.
FN realw principledthin_density_w(const Microfacets_w* f, real3w wo, real3w m, realw cosine) {
  realw normals = facets_normals_w(f, m);
  return splat_w(R(0.25)) * facets_density_w(f, wo, m, normals, cosine);
}

/// f times the cosine of wi over the Fresnel term.
FN realw principledthin_facets_w(const Microfacets_w* f, real3w wo, real3w in, real3w m) {
  realw seen = facets_masking_w(f, wo) * facets_masking_w(f, in) * abs_w(in.z);
  return splat_w(R(0.25)) * facets_normals_w(f, m) * seen;
}

SELDOM_FN real3w principledthin_eval_w(const Bsdf_w* b, real3w wi, PRIVATE realw* density) {
  realw zero = splat_w(R(0.0)), one = splat_w(R(1.0)), pi1 = splat_w(ONE_OVER_PI);
  PrincipledThin_w p = principledthin_of_w(b);
  maskw is_front = lt_w(zero, b->wo.z);
  real3w wo = sel3_w(is_front, b->wo, negate3_w(b->wo)), in = sel3_w(is_front, wi, negate3_w(wi));
  maskw is_lit = lt_w(zero, wo.z), is_reflected = is_lit & lt_w(zero, in.z), is_through = is_lit & lt_w(in.z, zero);
  real3w mirrored = vec3_w(in.x, in.y, abs_w(in.z)), m = normalize3_w(bisector_w(wo, mirrored));
  realw cosine = min_w(dot3_w(wo, m), one), far = dot3_w(in, m);
  maskw is_met = lt_w(zero, cosine) & ((is_reflected & lt_w(zero, far)) | (is_through & lt_w(far, zero)));
  Fresnel_w f = fresnel_w(max_w(cosine, zero), b->p[PRINCIPLEDTHIN_ETA_w]);
  realw trans = b->p[PRINCIPLEDTHIN_SPEC_TRANS_w], size = abs_w(in.z);
  realw above = trans * principledthin_facets_w(&p.above, wo, in, m);
  realw through = trans * (one - f.reflectance) * principledthin_facets_w(&p.through, wo, in, m);
  real3w color = bsdf_color_w(b, 0), value = black_w();
  real3w reflected = scale3_w(above, principledthin_reflectance_w(b, cosine, f));
  value = sel3_w(is_met, sel3_w(is_reflected, reflected, scale3_w(through, color)), value);
  realw dense = sel_w(is_reflected, p.glass_reflects * principledthin_density_w(&p.above, wo, m, cosine),
                      p.glass_transmits * principledthin_density_w(&p.through, wo, m, cosine));
  dense = sel_w(is_met, dense, zero);
  realw diffuse = disney_diffuse_w(b->p[PRINCIPLEDTHIN_ROUGHNESS_w], b->p[PRINCIPLEDTHIN_FLATNESS_w], wo.z, size, far);
  realw sheen = b->p[PRINCIPLEDTHIN_SHEEN_w] * schlick_weight_w(abs_w(far));
  real3w base = scale3_w(sheen, disney_sheen_color_w(color, b->p[PRINCIPLEDTHIN_SHEEN_TINT_w]));
  base = scale3_w(size * p.reflecting, fma3_w(diffuse * pi1, color, base));
  real3w behind = scale3_w(size * p.transmitting * pi1, color);
  value = sel3_w(is_reflected, add3_w(value, base), value);
  value = sel3_w(is_through, add3_w(value, behind), value);
  realw even = sel_w(is_reflected, p.base_reflects, p.base_transmits) * size * pi1;
  *density = sel_w(is_reflected | is_through, dense + even, zero);
  return value;
}

SELDOM_FN BsdfSample_w principledthin_sample_w(const Bsdf_w* b, int lobes, realw number, realw u, realw v) {
  (void)lobes;
  BsdfSample_w s = no_way_w(b);
  realw zero = splat_w(R(0.0)), one = splat_w(R(1.0));
  PrincipledThin_w p = principledthin_of_w(b);
  maskw is_front = lt_w(zero, b->wo.z);
  real3w wo = sel3_w(is_front, b->wo, negate3_w(b->wo));
  realw first = p.glass_reflects, second = first + p.glass_transmits, third = second + p.base_reflects;
  maskw is_glass = lt_w(number, second), is_above = lt_w(number, first) | (~is_glass & lt_w(number, third));
  // One draw: the microfacets of the lobe of each lane.
  Microfacets_w facets = p.above;
  facets.alpha_u = sel_w(is_above, p.above.alpha_u, p.through.alpha_u);
  facets.alpha_v = sel_w(is_above, p.above.alpha_v, p.through.alpha_v);
  real3w m = facets_draw_w(&facets, wo, u, v);
  realw cosine = dot3_w(wo, m);
  real3w in = sel3_w(is_glass, facets_mirror_w(wo, m, cosine), square_to_cosine_hemisphere_w(u, v));
  maskw is_drawn = lt_w(zero, in.z) & (~is_glass | lt_w(zero, cosine));
  in.z = sel_w(is_above, in.z, -in.z);
  // As Mitsuba: what is transmitted has to be below the microfacet too.
  is_drawn = is_drawn & (~is_glass | is_above | lt_w(dot3_w(in, m), zero));
  s.wi = sel3_w(is_front, in, negate3_w(in));
  real3w value = principledthin_eval_w(b, s.wi, &s.density);
  is_drawn = is_drawn & lt_w(zero, s.density);
  s.density = sel_w(is_drawn, s.density, zero);
  s.weight = sel3_w(is_drawn, scale3_w(one / sel_w(is_drawn, s.density, one), value), black_w());
  intw spread = sel_int_w(is_glass, splat_int_w(LOBE_GLOSSY), splat_int_w(LOBE_DIFFUSE));
  s.lobe = spread | sel_int_w(is_above, splat_int_w(LOBE_REFLECT), splat_int_w(LOBE_TRANSMIT));
  return s;
}
