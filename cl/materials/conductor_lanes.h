// SPDX-License-Identifier: MIT
// Smooth metal, seen from its front. Without METAL an ideal mirror: the same share of the light at every angle.
// Parameters: specular reflectance r g b; eta r g b, k r g b, the index of refraction over that outside.

enum { CONDUCTOR_ETA_w = 3, CONDUCTOR_K_w = 6 };

FN void conductor_load_w(const Scene* scene, const TexturePlace_w* at, int row, maskw which, Bsdf_w* b) {
  put_bsdf_color_w(b, which, 0, parameter_of_w(scene, at, row, 0));
  if (HAS_METAL) {
    put_bsdf_color_w(b, which, CONDUCTOR_ETA_w, parameter_of_w(scene, at, row, 1));
    put_bsdf_color_w(b, which, CONDUCTOR_K_w, parameter_of_w(scene, at, row, 2));
  }
}

FN real3w conductor_eval_w(const Bsdf_w* b, real3w wi, PRIVATE realw* density) {
  (void)b;
  (void)wi;
  *density = splat_w(R(0.0));
  return black_w();
}

FN BsdfSample_w conductor_sample_w(const Bsdf_w* b, int lobes, realw number, realw u, realw v) {
  (void)lobes;
  (void)number;
  (void)u;
  (void)v;
  BsdfSample_w s = no_way_w(b);
  s.wi = vec3_w(-b->wo.x, -b->wo.y, b->wo.z);
  real3w reflectance = bsdf_color_w(b, 0);
  if (HAS_METAL) {
    realw one = splat_w(R(1.0)), cosine = sel_w(lt_w(b->wo.z, one), b->wo.z, one);
    real3w eta = bsdf_color_w(b, CONDUCTOR_ETA_w), k = bsdf_color_w(b, CONDUCTOR_K_w);
    reflectance = mul3_w(reflectance, metal_reflectances_w(cosine, eta, k));
  }
  s.weight = sel3_w(lt_w(splat_w(R(0.0)), b->wo.z), reflectance, black_w());
  s.density = splat_w(R(1.0));
  s.lobe = splat_int_w(LOBE_DELTA | LOBE_REFLECT);
  return s;
}
