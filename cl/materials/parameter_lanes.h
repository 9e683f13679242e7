// SPDX-License-Identifier: MIT
// Parameters at points of surfaces. Each is one int of the material's row: if >= 0 an offset to constants, else the
// complement (~) of a row of the texture table. Few materials meet in one group of lanes: each row is read once, for
// all lanes that have it, since a gather takes ten times as long as a read (docs/decisions/0020-materials.md).
// textures/texture_lanes.h comes before. One width; no guard.

/// Up to three reals of one row, of use in the lanes that have it. number: the number of the parameter in the material.
FN real3w parameter_of_w(const Scene* scene, const TexturePlace_w* at, int row, int number) {
  int slot = scene->index[row + MATERIAL_SLOTS + number];
  if (TEXTURE_COUNT > 0 && slot < 0) return texture_value_w(scene, ~slot, at);
  return splat3_w(load3(scene->shading + slot));
}

/// The same of a row a lane, in the lanes of `which` that are at surfaces; 0 in the others. rows: offsets into the
/// index.
FN real3w parameter_at_w(const Scene* scene, const Surfaces_w* s, maskw which, intw rows, int number) {
  realw zero = splat_w(R(0.0));
  real3w value = vec3_w(zero, zero, zero);
  which = which & at_surfaces_w(s);
  if (!any_w(which)) return value;
  TexturePlace_w at = texture_place_w(scene, s);
  for (uint lanes = bits_w(which); lanes != 0u;) {
    int row;
    maskw is_one = next_alike_w(rows, which, &lanes, &row);
    value = sel3_w(is_one, parameter_of_w(scene, &at, row, number), value);
  }
  return value;
}
