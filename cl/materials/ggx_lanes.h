// SPDX-License-Identifier: MIT
// The distribution of microfacets of T. Trowbridge, K. Reitz, "Average Irregularity Representation of a Rough Surface
// for Ray Reflection", JOSA 65(5), 1975, and B. Walter and others, 2007 (GGX). One width; no guard.

FN realw ggx_normals_w(const Microfacets_w* f, real3w m) {
  realw x = m.x / f->alpha_u, y = m.y / f->alpha_v, q = fma_w(x, x, fma_w(y, y, m.z * m.z));
  return splat_w(ONE_OVER_PI) / (f->alpha_u * f->alpha_v * (q * q));
}

/// across: the stretched sine.
FN realw ggx_masking_w(realw z, realw across) { return splat_w(R(2.0)) / (z + sqrt_w(fma_w(z, z, across * across))); }

/// Stretched visible normal, of any length. wo: stretched, unit. J. Dupuy, A. Benyoub, "Sampling Visible GGX Normals
/// with Spherical Caps", HPG 2023.
FN real3w ggx_visible_normal_w(real3w wo, realw u, realw v) {
  realw one = splat_w(R(1.0)), span = one + wo.z;
  realw below = v * span, height = (one - v) * span;  // 1 - z; z + wo.z
  realw sine = sqrt_w(below * (splat_w(R(2.0)) - below));
  SinCos_w turned = sincos_turns_w(u);
  return vec3_w(fma_w(sine, turned.cosine, wo.x), fma_w(sine, turned.sine, wo.y), height);
}

/// As beckmann_steepness.
FN realw ggx_steepness_w(realw u) { return (splat_w(R(1.0)) - u) / u; }
