// SPDX-License-Identifier: MIT
// Passing on: a surface that is ignored. The path goes on behind it along the same ray; nothing else changes, not even
// depth and density. This holds for emitters hidden from the camera. A mask lets a path pass with the chance 1 -
// opacity; as in Mitsuba that counts as depth, shadow rays end at it, and emitters behind it are found by the path
// alone. One width; no guard.

/// The number by which a mask or a blend on the path's way is drawn: another one behind surfaces that are ignored,
/// which leave the depth as it is.
FN uintw met_number_w(const Scene* scene, const Paths_w* path, int use) {
  intw place = path->depth;
  if (HAS_PRIORITY) place = int_of_uint_w(uint_of_int_w(place) + uint_of_int_w(path->within.ignored) * IGNORED_STEP);
  return vertex_number_w(scene, &path->sample, place, use);
}

/// How far the rays of `which` reach that something has bent or let through: as in Mitsuba the camera's far_clip ends
/// at the first surface that is not ignored.
FN realw unclipped_w(maskw which, realw t_max) { return sel_w(which, splat_w(REAL_MAX), t_max); }

/// Lanes of `which` that pass on.
FN maskw passes_on_w(const Scene* scene, const Paths_w* path, const Surfaces_w* s, maskw which) {
  maskw on = none_w();
  if (HAS_EMISSION && hides_emitters(scene)) {
    maskw is_glowing = ~lt_int_w(part_entry_w(scene, s, PART_RADIANCE), splat_int_w(0));
    on = which & path->alive & lt_int_w(path->depth, splat_int_w(1)) & is_glowing;
  }
  return on;
}

/// Lanes of `which` that masks let pass. Density 0: no light is drawn through a mask.
FN maskw passes_masks_w(const Scene* scene, Paths_w* path, const MaterialRows_w* at, maskw which) {
  realw number = random_between_w(met_number_w(scene, path, USE_MASK));
  which = which & le_w(at->opacity, number);
  path->depth = sel_int_w(which, path->depth + splat_int_w(1), path->depth);
  path->density = sel_w(which, splat_w(R(0.0)), path->density);
  return which;
}
