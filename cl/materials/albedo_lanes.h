// SPDX-License-Identifier: MIT
// The colour of a surface beside the picture, for who removes noise: what the material's first parameter says, with its
// texture. That is the diffuse base where there is one, the reflectance or transmittance of the others, white of plain
// glass; of metals times what their index reflects at normal incidence, per channel. One width; no guard.

/// Of the rows that the lanes of `which` have; times the opacity of masks.
FN real3w albedo_at_w(const Scene* scene, const Surfaces_w* s, maskw which, const MaterialRows_w* at) {
  realw zero = splat_w(R(0.0)), one = splat_w(R(1.0));
  real3w color = parameter_at_w(scene, s, which, at->rows, 0);
  maskw is_metal = which & has_indices_w(scene, at->rows, INDICES_OF_METAL);
  if (any_w(is_metal)) {
    real3w eta = parameter_at_w(scene, s, is_metal, at->rows, 1), k = parameter_at_w(scene, s, is_metal, at->rows, 2);
    real3w less = vec3_w(eta.x - one, eta.y - one, eta.z - one), more = vec3_w(eta.x + one, eta.y + one, eta.z + one);
    real3w reflected = vec3_w(fma_w(less.x, less.x, k.x * k.x) / fma_w(more.x, more.x, k.x * k.x),
                              fma_w(less.y, less.y, k.y * k.y) / fma_w(more.y, more.y, k.y * k.y),
                              fma_w(less.z, less.z, k.z * k.z) / fma_w(more.z, more.z, k.z * k.z));
    color = sel3_w(is_metal, mul3_w(color, reflected), color);
  }
  if (HAS_MASK) color = scale3_w(at->opacity, color);
  return sel3_w(which, color, vec3_w(zero, zero, zero));
}
