// SPDX-License-Identifier: MIT
// A diffuse base under a smooth dielectric, seen from its front: what the boundary lets through is scattered by the
// base, and what it throws back from within is scattered again, summed (as Mitsuba's). Parameters: diffuse reflectance
// r g b, specular reflectance r g b; the base's (base_lanes.h).

enum { PLASTIC_SPECULAR_w = 3, PLASTIC_BASE_w = 6, PLASTIC_ETA_w = 6 };

FN void plastic_load_w(const Scene* scene, const TexturePlace_w* at, int row, maskw which, Bsdf_w* b) {
  for (int slot = 0; slot < 4; ++slot) put_bsdf_color_w(b, which, 3 * slot, parameter_of_w(scene, at, row, slot));
}

FN Fresnel_w plastic_fresnel_w(const Bsdf_w* b, realw cosine) {
  realw zero = splat_w(R(0.0)), one = splat_w(R(1.0));
  return fresnel_w(min_w(max_w(cosine, zero), one), b->p[PLASTIC_ETA_w]);
}

FN real3w plastic_eval_w(const Bsdf_w* b, real3w wi, PRIVATE realw* density) {
  realw zero = splat_w(R(0.0));
  maskw is_lit = lt_w(zero, wi.z) & lt_w(zero, b->wo.z);
  realw out = plastic_fresnel_w(b, b->wo.z).transmittance, in = plastic_fresnel_w(b, wi.z).transmittance;
  realw lambert = wi.z * splat_w(ONE_OVER_PI);
  *density = sel_w(is_lit, base_chance_w(b, PLASTIC_BASE_w, out) * lambert, zero);
  return sel3_w(is_lit, scale3_w(lambert * out * in, base_color_w(b, PLASTIC_BASE_w)), black_w());
}

FN BsdfSample_w plastic_sample_w(const Bsdf_w* b, int lobes, realw number, realw u, realw v) {
  BsdfSample_w s = no_way_w(b);
  realw zero = splat_w(R(0.0)), one = splat_w(R(1.0));
  Fresnel_w out = plastic_fresnel_w(b, b->wo.z);
  int is_either = (lobes & LOBE_DELTA) != 0 && (lobes & LOBE_DIFFUSE) != 0;
  realw rest = is_either ? base_chance_w(b, PLASTIC_BASE_w, out.transmittance) : one;
  realw chance = is_either ? one - rest : one;
  maskw is_specular = is_either ? lt_w(number, chance) : (lobes & LOBE_DELTA) != 0 ? ~none_w() : none_w();
  maskw is_lit = lt_w(zero, b->wo.z);
  real3w mirrored = vec3_w(-b->wo.x, -b->wo.y, b->wo.z), diffuse = square_to_cosine_hemisphere_w(u, v);
  s.wi = sel3_w(is_specular, mirrored, diffuse);
  realw in = plastic_fresnel_w(b, diffuse.z).transmittance;
  real3w specular = scale3_w(out.reflectance / sel_w(is_specular, chance, one), bsdf_color_w(b, PLASTIC_SPECULAR_w));
  realw through = out.transmittance * in / sel_w(is_specular, one, rest);
  real3w weight = sel3_w(is_specular, specular, scale3_w(through, base_color_w(b, PLASTIC_BASE_w)));
  s.weight = sel3_w(is_lit, weight, black_w());
  s.density = sel_w(is_specular, chance, sel_w(is_lit, rest * diffuse.z * splat_w(ONE_OVER_PI), zero));
  s.lobe = sel_int_w(is_specular, splat_int_w(LOBE_DELTA | LOBE_REFLECT), splat_int_w(LOBE_DIFFUSE | LOBE_REFLECT));
  return s;
}
