// SPDX-License-Identifier: MIT
// Lambertian reflection, f = rho / pi. Parameters: rho r g b.

FN realw LANED(diffuse_density)(real3w reflectance, real3w wi, real3w wo) {
  (void)reflectance;
  realw zero = splat_w(R(0.0));
  return sel_w(lt_w(zero, wi.z) & lt_w(zero, wo.z), wi.z * splat_w(ONE_OVER_PI), zero);
}

FN real3w LANED(diffuse_eval)(real3w reflectance, real3w wi, real3w wo) {
  return scale3_w(LANED(diffuse_density)(reflectance, wi, wo), reflectance);
}

FN LANED(MaterialSample) LANED(diffuse_sample)(real3w reflectance, real3w wo, realw u, realw v) {
  LANED(MaterialSample) s;
  s.wi = LANED(square_to_cosine_hemisphere)(u, v);
  s.weight = sel3_w(lt_w(splat_w(R(0.0)), wo.z), reflectance, LANED(black)());
  s.density = s.wi.z * splat_w(ONE_OVER_PI);
  return s;
}

FN real3w LANED(diffuse_mirror)(real3w reflectance) {
  (void)reflectance;
  return LANED(black)();
}
