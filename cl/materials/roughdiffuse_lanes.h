// SPDX-License-Identifier: MIT
// A surface of diffuse facets, seen from its front: M. Oren, S. Nayar, "Generalization of Lambert's Reflectance Model",
// SIGGRAPH 1994, as Mitsuba 0.x has it: with light that is reflected twice, or the paper's simpler form without.
// Parameters: reflectance r g b; alpha, of which sqrt(1/2) is the standard deviation of the facets' angle; 1: the
// simpler form.

enum { ROUGHDIFFUSE_ALPHA_w = 3, ROUGHDIFFUSE_FAST_w = 6 };

FN void roughdiffuse_load_w(const Scene* scene, const TexturePlace_w* at, int row, maskw which, Bsdf_w* b) {
  for (int slot = 0; slot < 3; ++slot) {
    real3w value = parameter_of_w(scene, at, row, slot);
    int is_number = 3 * slot == ROUGHDIFFUSE_ALPHA_w;
    if (is_number) value.x = luminance_w(value);
    put_bsdf_color_w(b, which, 3 * slot, value);
  }
}

SELDOM_FN real3w roughdiffuse_eval_w(const Bsdf_w* b, real3w wi, PRIVATE realw* density) {
  realw zero = splat_w(R(0.0)), one = splat_w(R(1.0)), half_one = splat_w(R(0.5)), four = splat_w(R(4.0));
  real3w wo = b->wo;
  maskw is_lit = lt_w(zero, wi.z) & lt_w(zero, wo.z), is_steeper = lt_w(wo.z, wi.z);
  *density = sel_w(is_lit, wi.z * splat_w(ONE_OVER_PI), zero);
  realw alpha = b->p[ROUGHDIFFUSE_ALPHA_w], v = half_one * alpha * alpha;
  realw in = sqrt_w(fma_w(wi.x, wi.x, wi.y * wi.y)), out = sqrt_w(fma_w(wo.x, wo.x, wo.y * wo.y)), both = in * out;
  // Of the difference of the directions around the normal.
  realw across = fma_w(wi.x, wo.x, wi.y * wo.y) / sel_w(lt_w(zero, both), both, one);
  across = min_w(max_w(across, -one), one);
  // Sine and cosine of the larger angle from the normal, and of the smaller one.
  realw s1 = sel_w(is_steeper, out, in), c1 = sel_w(is_steeper, wo.z, wi.z);
  realw s2 = sel_w(is_steeper, in, out), c2 = sel_w(is_steeper, wi.z, wo.z);
  realw a = v / (v + splat_w(R(0.09))), single = one - half_one * v / (v + splat_w(R(0.33)));
  realw tangent = s2 / sel_w(is_lit, c2, one), behind = max_w(across, zero);
  realw fast = fma_w(splat_w(R(0.45)) * a * behind * s1, tangent, single);
  // In units of a right angle.
  realw larger = four * atan2_turns_w(s1, c1), smaller = four * atan2_turns_w(s2, c2);
  realw second = splat_w(R(0.45)) * a * (s1 - sel_w(lt_w(across, zero), smaller * smaller * smaller, zero));
  realw third = splat_w(R(0.125)) * a * (larger * smaller) * (larger * smaller);
  realw sum = c1 + c2, middle = (s1 + s2) / sel_w(is_lit, sum, one);
  single = fma_w(across * second, tangent, single);
  single = fma_w((one - abs_w(across)) * third, middle, single);
  realw twice = splat_w(R(0.17)) * v / (v + splat_w(R(0.13))) * fma_w(-across, smaller * smaller, one);
  maskw is_fast = lt_w(zero, b->p[ROUGHDIFFUSE_FAST_w]);
  real3w color = bsdf_color_w(b, 0);
  real3w once = scale3_w(sel_w(is_fast, fast, single), color);
  real3w value = fma3_w(sel_w(is_fast, zero, twice), mul3_w(color, color), once);
  return scale3_w(*density, vec3_w(max_w(value.x, zero), max_w(value.y, zero), max_w(value.z, zero)));
}

SELDOM_FN BsdfSample_w roughdiffuse_sample_w(const Bsdf_w* b, int lobes, realw number, realw u, realw v) {
  (void)lobes;
  (void)number;
  BsdfSample_w s = no_way_w(b);
  realw zero = splat_w(R(0.0)), one = splat_w(R(1.0));
  s.wi = square_to_cosine_hemisphere_w(u, v);
  real3w value = roughdiffuse_eval_w(b, s.wi, &s.density);
  maskw is_drawn = lt_w(zero, s.density);
  s.weight = sel3_w(is_drawn, scale3_w(one / sel_w(is_drawn, s.density, one), value), black_w());
  s.lobe = splat_int_w(LOBE_DIFFUSE | LOBE_REFLECT);
  return s;
}
