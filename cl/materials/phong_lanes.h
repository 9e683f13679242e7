// SPDX-License-Identifier: MIT
// B. Phong's highlight around the mirrored direction over a diffuse base, seen from its front, normalised as by E.
// Lafortune, Y. Willems, "Using the Modified Phong Reflectance Model for Physically Based Rendering", 1994; as Mitsuba
// 0.x has it. Parameters: diffuse reflectance r g b, specular reflectance r g b; the exponent; the chance of the
// highlight, 0, what multiplies both reflectances.

enum { PHONG_SPECULAR_w = 3, PHONG_EXPONENT_w = 6, PHONG_CHANCE_w = 9 };

FN void phong_load_w(const Scene* scene, const TexturePlace_w* at, int row, maskw which, Bsdf_w* b) {
  real3w chance = parameter_of_w(scene, at, row, 3);
  for (int slot = 0; slot < 3; ++slot) {
    real3w value = parameter_of_w(scene, at, row, slot);
    int is_number = 3 * slot == PHONG_EXPONENT_w;
    if (is_number)
      value.x = luminance_w(value);
    else
      value = scale3_w(chance.z, value);
    put_bsdf_color_w(b, which, 3 * slot, value);
  }
  put_bsdf_color_w(b, which, PHONG_CHANCE_w, chance);
}

/// The cosine of wi and the mirrored wo, to the power of the exponent.
FN realw phong_power_w(const Bsdf_w* b, real3w wi) {
  realw zero = splat_w(R(0.0)), one = splat_w(R(1.0));
  realw cosine = fma_w(wi.z, b->wo.z, -fma_w(wi.y, b->wo.y, wi.x * b->wo.x));
  maskw is_above = lt_w(zero, cosine);
  realw power = exp_minus_w(b->p[PHONG_EXPONENT_w] * minus_log_w(sel_w(is_above, min_w(cosine, one), one)));
  return sel_w(is_above, power, zero);
}

SELDOM_FN real3w phong_eval_w(const Bsdf_w* b, real3w wi, PRIVATE realw* density) {
  realw zero = splat_w(R(0.0)), one = splat_w(R(1.0)), half_pi1 = splat_w(R(0.5) * ONE_OVER_PI);
  maskw is_lit = lt_w(zero, wi.z) & lt_w(zero, b->wo.z);
  realw exponent = b->p[PHONG_EXPONENT_w], lambert = wi.z * splat_w(ONE_OVER_PI),
        power = half_pi1 * phong_power_w(b, wi);
  realw chance = b->p[PHONG_CHANCE_w], drawn = (exponent + one) * power;
  *density = sel_w(is_lit, fma_w(chance, drawn, (one - chance) * lambert), zero);
  realw highlight = (exponent + splat_w(R(2.0))) * power * wi.z;
  real3w value = fma3_w(highlight, bsdf_color_w(b, PHONG_SPECULAR_w), scale3_w(lambert, bsdf_color_w(b, 0)));
  return sel3_w(is_lit, value, black_w());
}

/// 1 - e^-y for y >= 0, to its roundoff where y is small.
FN realw phong_rest_w(realw y) {
  realw one = splat_w(R(1.0)), third = splat_w(R(0.33333333333333333333)), quarter = splat_w(R(0.25));
  realw fifth = splat_w(R(0.2)), sixth = splat_w(R(0.16666666666666666667)), half_one = splat_w(R(0.5));
  realw series = one - y * sixth;
  series = fma_w(-y * fifth, series, one);
  series = fma_w(-y * quarter, series, one);
  series = fma_w(-y * third, series, one);
  series = y * fma_w(-y * half_one, series, one);
  // The next term is y^6 / 5040 of it: below 2^-30 here.
  return sel_w(lt_w(y, splat_w(R(0.1))), series, one - exp_minus_w(y));
}

SELDOM_FN BsdfSample_w phong_sample_w(const Bsdf_w* b, int lobes, realw number, realw u, realw v) {
  (void)lobes;
  BsdfSample_w s = no_way_w(b);
  realw zero = splat_w(R(0.0)), one = splat_w(R(1.0)), two = splat_w(R(2.0));
  maskw is_specular = lt_w(number, b->p[PHONG_CHANCE_w]);
  // The cosine from the mirrored direction is u to the power of 1 / (exponent + 1).
  realw steep = minus_log_w(u) / (b->p[PHONG_EXPONENT_w] + one), sine = sqrt_w(phong_rest_w(two * steep));
  SinCos_w turned = sincos_turns_w(v);
  Frame_w mirror = frame_around_w(vec3_w(-b->wo.x, -b->wo.y, b->wo.z));
  real3w glossy = from_frame_w(&mirror, vec3_w(sine * turned.cosine, sine * turned.sine, exp_minus_w(steep)));
  s.wi = sel3_w(is_specular, normalize3_w(glossy), square_to_cosine_hemisphere_w(u, v));
  real3w value = phong_eval_w(b, s.wi, &s.density);
  maskw is_drawn = lt_w(zero, s.density);
  s.weight = sel3_w(is_drawn, scale3_w(one / sel_w(is_drawn, s.density, one), value), black_w());
  s.lobe = sel_int_w(is_specular, splat_int_w(LOBE_GLOSSY | LOBE_REFLECT), splat_int_w(LOBE_DIFFUSE | LOBE_REFLECT));
  return s;
}
