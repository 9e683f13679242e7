// SPDX-License-Identifier: MIT
// Parameters at points of surfaces. Each is one int of the material's row: if >= 0 an offset to constants, else the
// complement (~) of a row of the texture table. textures/texture_lanes.h comes before. One width; no guard.

/// Reads up to three reals in the lanes of `which`. number: the number of the parameter in the material. rows: offsets
/// into the index.
FN real3w parameter_at_w(const Scene* scene, const Surfaces_w* s, maskw which, intw rows, int number) {
  intw slot = gather_int_w(scene->index + MATERIAL_SLOTS + number, rows);
  if (TEXTURE_COUNT == 0) return gather3_w(scene->shading, slot);
  maskw is_texture = lt_int_w(slot, splat_int_w(0));
  real3w value = gather3_w(scene->shading, sel_int_w(is_texture, splat_int_w(0), slot));
  return texture_values_w(scene, s, which & s->hit & is_texture, ~slot, value);
}
