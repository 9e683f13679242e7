// SPDX-License-Identifier: MIT
// A smooth boundary between two media that absorb nothing: a share of the light is reflected (Fresnel), the rest is
// refracted (Snell). Radiance that goes from one medium into the other scales by the square of their indices' ratio
// (E. Veach, "Robust Monte Carlo Methods for Light Transport Simulation", 1997, section 5.2). Parameters: specular
// reflectance r g b, specular transmittance r g b, index of refraction inside over outside; those of inside and of
// outside, which count where overlapping glass is tracked (core/interfaces_lanes.h).
#include "math/fresnel_lanes.h"

enum { LANED(DIELECTRIC_TRANSMITTANCE) = 3, LANED(DIELECTRIC_ETA) = 6 };

FN void LANED(dielectric_load)(const Scene* scene, const LANED(Surfaces) * s, intw rows, maskw which, LANED(Bsdf) * b) {
  LANED(put_bsdf_color)(b, which, 0, LANED(parameter_at)(scene, s, which, rows, 0));
  LANED(put_bsdf_color)(b, which, LANED(DIELECTRIC_TRANSMITTANCE), LANED(parameter_at)(scene, s, which, rows, 1));
  LANED(put_bsdf_color)(b, which, LANED(DIELECTRIC_ETA), LANED(parameter_at)(scene, s, which, rows, 2));
}

FN real3w LANED(dielectric_eval)(const LANED(Bsdf) * b, real3w wi, PRIVATE realw* density) {
  (void)b;
  (void)wi;
  *density = splat_w(R(0.0));
  return LANED(black)();
}

FN LANED(BsdfSample) LANED(dielectric_sample)(const LANED(Bsdf) * b, int lobes, realw number, realw u, realw v) {
  (void)u;
  (void)v;
  LANED(BsdfSample) s = LANED(no_way)(b);
  realw one = splat_w(R(1.0));
  maskw is_inside = lt_w(b->wo.z, splat_w(R(0.0)));
  realw eta = sel_w(is_inside, one / b->p[LANED(DIELECTRIC_ETA)], b->p[LANED(DIELECTRIC_ETA)]), inverse = one / eta;
  LANED(Fresnel) f = LANED(fresnel)(abs_w(b->wo.z), eta);
  int is_either = (lobes & LOBE_SIDES) == LOBE_SIDES;
  maskw is_reflected = lt_w(number, f.reflectance);
  if (!is_either) is_reflected = (lobes & LOBE_REFLECT) != 0 ? ~none_w() : none_w();
  realw chance = sel_w(is_reflected, f.reflectance, one - f.reflectance);
  real3w through = scale3_w(inverse * inverse, LANED(bsdf_color)(b, LANED(DIELECTRIC_TRANSMITTANCE)));
  s.weight = sel3_w(is_reflected, LANED(bsdf_color)(b, 0), through);
  if (!is_either) s.weight = scale3_w(chance, s.weight);
  s.density = is_either ? chance : one;
  s.eta = sel_w(is_reflected, one, eta);
  s.lobe = sel_int_w(is_reflected, splat_int_w(LOBE_DELTA | LOBE_REFLECT), splat_int_w(LOBE_DELTA | LOBE_TRANSMIT));
  real3w mirrored = vec3_w(-b->wo.x, -b->wo.y, b->wo.z);
  realw depth = sel_w(is_inside, f.cosine, -f.cosine);
  s.wi = sel3_w(is_reflected, mirrored, vec3_w(-inverse * b->wo.x, -inverse * b->wo.y, depth));
  return s;
}
