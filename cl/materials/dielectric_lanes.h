// SPDX-License-Identifier: MIT
// A smooth boundary between two media that absorb nothing: a share of the light is reflected (Fresnel), the rest is
// refracted (Snell). Radiance that goes from one medium into the other scales by the square of their indices' ratio
// (E. Veach, "Robust Monte Carlo Methods for Light Transport Simulation", 1997, section 5.2). Parameters: specular
// reflectance r g b, specular transmittance r g b, index of refraction inside over outside; then the two indices,
// inside and outside, which are used where overlapping glass is tracked (integrators/interfaces_lanes.h).
enum { DIELECTRIC_TRANSMITTANCE_w = 3, DIELECTRIC_ETA_w = 6 };

FN void dielectric_load_w(const Scene* scene, const TexturePlace_w* at, int row, maskw which, Bsdf_w* b) {
  put_bsdf_color_w(b, which, 0, parameter_of_w(scene, at, row, 0));
  put_bsdf_color_w(b, which, DIELECTRIC_TRANSMITTANCE_w, parameter_of_w(scene, at, row, 1));
  put_bsdf_color_w(b, which, DIELECTRIC_ETA_w, parameter_of_w(scene, at, row, 2));
}

FN real3w dielectric_eval_w(const Bsdf_w* b, real3w wi, PRIVATE realw* density) {
  (void)b;
  (void)wi;
  *density = splat_w(R(0.0));
  return black_w();
}

FN BsdfSample_w dielectric_sample_w(const Bsdf_w* b, int lobes, realw number, realw u, realw v) {
  (void)u;
  (void)v;
  BsdfSample_w s = no_way_w(b);
  realw one = splat_w(R(1.0));
  maskw is_inside = lt_w(b->wo.z, splat_w(R(0.0)));
  realw eta = sel_w(is_inside, one / b->p[DIELECTRIC_ETA_w], b->p[DIELECTRIC_ETA_w]), inverse = one / eta;
  Fresnel_w f = fresnel_w(abs_w(b->wo.z), eta);
  int is_either = (lobes & LOBE_SIDES) == LOBE_SIDES;
  maskw is_reflected = lt_w(number, f.reflectance);
  if (!is_either) is_reflected = (lobes & LOBE_REFLECT) != 0 ? ~none_w() : none_w();
  realw chance = sel_w(is_reflected, f.reflectance, one - f.reflectance);
  real3w through = scale3_w(inverse * inverse, bsdf_color_w(b, DIELECTRIC_TRANSMITTANCE_w));
  s.weight = sel3_w(is_reflected, bsdf_color_w(b, 0), through);
  if (!is_either) s.weight = scale3_w(chance, s.weight);
  s.density = is_either ? chance : one;
  s.eta = sel_w(is_reflected, one, eta);
  s.lobe = sel_int_w(is_reflected, splat_int_w(LOBE_DELTA | LOBE_REFLECT), splat_int_w(LOBE_DELTA | LOBE_TRANSMIT));
  real3w mirrored = vec3_w(-b->wo.x, -b->wo.y, b->wo.z);
  realw depth = sel_w(is_inside, f.cosine, -f.cosine);
  s.wi = sel3_w(is_reflected, mirrored, vec3_w(-inverse * b->wo.x, -inverse * b->wo.y, depth));
  return s;
}
