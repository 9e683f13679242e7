// SPDX-License-Identifier: MIT
// Terms of B. Burley's materials ("Physically Based Shading at Disney", SIGGRAPH 2012 courses; "Extending the Disney
// BRDF to a BSDF with Integrated Subsurface Scattering", SIGGRAPH 2015 courses). One width; no guard.

/// GGX, visible normals: roughness squared, stretched along x.
FN Microfacets_w disney_facets_w(realw roughness, realw anisotropic) {
  Microfacets_w f;
  realw least = splat_w(R(1e-3)), one = splat_w(R(1.0));  // As Mitsuba; held by tests/physics/test_mitsuba_bsdfs.cpp.
  realw aspect = sqrt_w(fma_w(splat_w(R(-0.9)), anisotropic, one)), square = roughness * roughness;
  f.alpha_u = max_w(square / aspect, least);
  f.alpha_v = max_w(square * aspect, least);
  f.is_ggx = f.is_visible = ~none_w();
  return f;
}

/// (1 - cosine)^5: C. Schlick, "An Inexpensive BRDF Model for Physically-based Rendering", Eurographics 1994.
FN realw schlick_weight_w(realw cosine) {
  realw x = splat_w(R(1.0)) - min_w(max_w(cosine, splat_w(R(0.0))), splat_w(R(1.0))), square = x * x;
  return square * square * x;
}

/// From f0 at normal incidence to 1.
FN real3w schlick3_w(real3w f0, realw weight) {
  realw rest = splat_w(R(1.0)) - weight;
  return fma3_w(rest, f0, vec3_w(weight, weight, weight));
}

/// The colour without its luminance; white where it is black.
FN real3w disney_tint_w(real3w color) {
  realw one = splat_w(R(1.0)), luminance = luminance_w(color);
  maskw is_bright = lt_w(splat_w(R(0.0)), luminance);
  return sel3_w(is_bright, scale3_w(one / sel_w(is_bright, luminance, one), color), vec3_w(one, one, one));
}

/// What a dielectric of that index reflects at normal incidence, tinted.
FN real3w disney_tinted_f0_w(real3w color, realw eta) {
  realw one = splat_w(R(1.0)), root = (eta - one) / (eta + one);
  return scale3_w(root * root, disney_tint_w(color));
}

FN real3w disney_sheen_color_w(real3w color, realw tint) {
  realw one = splat_w(R(1.0)), rest = one - tint;
  return fma3_w(tint, disney_tint_w(color), vec3_w(rest, rest, rest));
}

/// Diffuse reflection times pi over the colour, with retro-reflection; flatness: towards the look of P. Hanrahan's and
/// W. Krueger's subsurface model. cosine: of wi and the half vector.
FN realw disney_diffuse_w(realw roughness, realw flatness, realw out, realw in, realw cosine) {
  realw one = splat_w(R(1.0)), half_one = splat_w(R(0.5)), a = schlick_weight_w(in), b = schlick_weight_w(out);
  realw retro = splat_w(R(2.0)) * roughness * cosine * cosine;
  realw lambert = fma_w(-half_one, a, one) * fma_w(-half_one, b, one);
  realw plain = fma_w(retro, a + b + a * b * (retro - one), lambert);
  realw at_90 = half_one * retro - one, both = fma_w(a, at_90, one) * fma_w(b, at_90, one), sum = in + out;
  realw far = one / sel_w(lt_w(splat_w(R(0.0)), sum), sum, one);
  realw flat = splat_w(R(1.25)) * fma_w(both, far - half_one, half_one);
  return fma_w(flatness, flat - plain, plain);
}

/// The clear coat's normals, a distribution with long tails (Burley's GTR1), by solid angle and projected area.
FN realw gtr1_normals_w(realw alpha, real3w m) {
  realw square = alpha * alpha, bent = fma_w(m.x, m.x, m.y * m.y),
        rest = (splat_w(R(1.0)) - alpha) * (splat_w(R(1.0)) + alpha);
  realw divisor = splat_w(R(2.0)) * minus_log_w(alpha) * fma_w(square, m.z * m.z, bent);
  return splat_w(ONE_OVER_PI) * rest / divisor;
}

/// A normal of it, by u and v within (0, 1).
FN real3w gtr1_draw_w(realw alpha, realw u, realw v) {
  realw zero = splat_w(R(0.0)), one = splat_w(R(1.0)), two = splat_w(R(2.0)), depth = two * minus_log_w(alpha);
  realw rest = (one - alpha) * (one + alpha), sine2 = (exp_minus_w((one - v) * depth) - alpha * alpha) / rest;
  sine2 = min_w(max_w(sine2, zero), one);
  realw sine = sqrt_w(sine2);
  SinCos_w turned = sincos_turns_w(u);
  return vec3_w(sine * turned.cosine, sine * turned.sine, sqrt_w(one - sine2));
}

/// The share of the coat's microfacets that is seen at a cosine: GGX's of roughness 1/4.
FN realw disney_coat_masking_w(realw cosine) {
  realw alpha = splat_w(R(0.25)), one = splat_w(R(1.0)), sine2 = (one - cosine) * (one + cosine);
  realw across2 = alpha * alpha * max_w(sine2, splat_w(R(0.0)));
  return splat_w(R(2.0)) * cosine / (cosine + sqrt_w(fma_w(cosine, cosine, across2)));
}
