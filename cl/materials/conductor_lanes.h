// SPDX-License-Identifier: MIT
// Ideal mirror: the same share of the light at every angle. Parameters: specular reflectance r g b.

/// No light that was drawn is reflected into any other direction but one.
FN real3w LANED(conductor_eval)(real3w reflectance, real3w wi, real3w wo) {
  (void)reflectance;
  (void)wi;
  (void)wo;
  return LANED(black)();
}

FN realw LANED(conductor_density)(real3w reflectance, real3w wi, real3w wo) {
  (void)reflectance;
  (void)wi;
  (void)wo;
  return splat_w(R(0.0));
}

FN LANED(MaterialSample) LANED(conductor_sample)(real3w reflectance, real3w wo, realw u, realw v) {
  (void)u;
  (void)v;
  LANED(MaterialSample) s;
  realw zero = splat_w(R(0.0));
  s.wi = vec3_w(-wo.x, -wo.y, wo.z);
  s.weight = sel3_w(lt_w(zero, wo.z), reflectance, LANED(black)());
  s.density = zero;
  return s;
}

FN real3w LANED(conductor_mirror)(real3w reflectance) { return reflectance; }
