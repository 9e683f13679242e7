// SPDX-License-Identifier: MIT
// Passing on: a surface that is ignored. The path goes on behind it along the same ray; nothing else changes, not even
// depth and density. This holds for emitters hidden from the camera. Any other surface that lets rays through unchanged
// is to be added here. One width; no guard.

/// Lanes of `which` that pass on.
FN maskw passes_on_w(const Scene* scene, const Paths_w* path, const Surfaces_w* s, maskw which) {
  maskw on = none_w();
  if (HAS_EMISSION && hides_emitters(scene)) {
    maskw is_glowing = ~lt_int_w(part_entry_w(scene, s, PART_RADIANCE), splat_int_w(0));
    on = which & path->alive & lt_int_w(path->depth, splat_int_w(1)) & is_glowing;
  }
  return on;
}
