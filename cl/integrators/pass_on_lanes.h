// SPDX-License-Identifier: MIT
// Pass on: a surface that is looked through. The path goes on behind it along the same ray, and nothing else changes,
// its depth and its density included. Emitters hidden from the camera do so; whatever else lets rays through untouched
// is to be told here. One width; no guard.

/// Lanes of `which` that pass on.
FN maskw passes_on_w(const Scene* scene, const Paths_w* path, const Surfaces_w* s, maskw which) {
  maskw on = none_w();
  if (HAS_EMISSION && hides_emitters(scene)) {
    maskw is_glowing = ~lt_int_w(part_entry_w(scene, s, PART_RADIANCE), splat_int_w(0));
    on = which & path->alive & lt_int_w(path->depth, splat_int_w(1)) & is_glowing;
  }
  return on;
}
