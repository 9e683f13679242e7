// SPDX-License-Identifier: MIT
// The diffuse base of plastics: what the boundary above it lets through is scattered, and what the boundary throws back
// from within is scattered again. Parameters: reflectance r g b in the first three of the material; elsewhere the index
// of refraction inside over outside, the weight of specular draws, whether the base colours every inner reflection; the
// share of diffuse light that the boundary reflects from within, one over the index squared. One width; no guard.

enum { BASE_ETA_w = 0, BASE_WEIGHT_w = 1, BASE_NONLINEAR_w = 2, BASE_INNER_w = 3, BASE_INVERSE_w = 4 };

/// The chance of the diffuse lobe, where the boundary lets so much through: with the digits of `through`, however
/// small.
FN realw base_chance_w(const Bsdf_w* b, int base, realw through) {
  realw zero = splat_w(R(0.0)), one = splat_w(R(1.0)), weight = b->p[base + BASE_WEIGHT_w];
  realw diffuse = through * (one - weight), sum = fma_w(one - through, weight, diffuse);
  return sel_w(lt_w(zero, sum), diffuse / sum, zero);
}

/// The base's reflectance, all inner reflections summed.
FN real3w base_color_w(const Bsdf_w* b, int base) {
  realw one = splat_w(R(1.0)), inner = b->p[base + BASE_INNER_w];
  maskw is_nonlinear = lt_w(splat_w(R(0.0)), b->p[base + BASE_NONLINEAR_w]);
  real3w own = bsdf_color_w(b, 0), none = vec3_w(one, one, one), by = sel3_w(is_nonlinear, own, none);
  real3w rest = vec3_w(fma_w(-inner, by.x, one), fma_w(-inner, by.y, one), fma_w(-inner, by.z, one));
  real3w all = vec3_w(own.x / rest.x, own.y / rest.y, own.z / rest.z);
  return scale3_w(b->p[base + BASE_INVERSE_w], all);
}
