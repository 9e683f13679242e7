// SPDX-License-Identifier: MIT
// Overlapping glass with priorities: the index of refraction on the far side is that of the medium that is really
// there. Of materials that are no dielectric, boundaries of media alone have a rank. One width; no guard.

enum { TRACKED_ETA_w = 6, TRACKED_INSIDE_w = 7, TRACKED_INDICES_w = 2 };  // The last is their parameter.

/// Writes the indices of the two media into b, in the lanes of `which` that are at an interface of two such shapes.
FN Crossing_w crossing_of_w(const Scene* scene, const Interfaces_w* within, const Surfaces_w* s,
                            const MaterialRows_w* at, maskw which, Bsdf_w* b) {
  // A program whose materials have fewer parameters has no glass.
  int eta = (int)BSDF_REALS > TRACKED_INSIDE_w ? TRACKED_ETA_w : 0;
  int inside = (int)BSDF_REALS > TRACKED_INSIDE_w ? TRACKED_INSIDE_w : 0;
  maskw is_glass = ~none_w();
#if HAS_MEDIA
  is_glass = has_indices_w(scene, at->rows, INDICES_OF_GLASS);
#else
  (void)at;
#endif
  Crossing_w c = crossing_at_w(scene, within, s, which, sel_w(is_glass, b->p[inside], splat_w(R(0.0))));
  // No other such shape around: the ratio that the host has computed is rounded only once.
  b->p[eta] = sel_w(c.which & c.is_amid & is_glass, c.ior / c.other, b->p[eta]);
  return c;
}

/// Of crossings whose material is not evaluated: the index within, 0 of what is no glass.
FN realw index_within_w(const Scene* scene, const Surfaces_w* s, const MaterialRows_w* at, maskw which) {
  maskw is_glass = which & has_indices_w(scene, at->rows, INDICES_OF_GLASS);
  realw ior = splat_w(R(0.0));
  if (any_w(is_glass)) ior = sel_w(is_glass, parameter_at_w(scene, s, is_glass, at->rows, TRACKED_INDICES_w).y, ior);
  return ior;
}

/// The paths of `which` go on along d through holes of masks: lists are kept.
SELDOM_FN void pass_holes_w(const Scene* scene, Paths_w* path, const Surfaces_w* s, const MaterialRows_w* at,
                            maskw which, real3w d) {
  Crossing_w c = crossing_at_w(scene, &path->within, s, which, index_within_w(scene, s, at, which));
  cross_interface_w(scene, &c, which & goes_through_w(&c, s, d), &path->within);
}

/// Paths pass the surfaces that are ignored; which these are. Shadow rays end at them, so what emits behind is found by
/// the path alone.
FN maskw pass_unreal_w(const Scene* scene, Paths_w* path, const Crossing_w* c) {
  maskw unreal = c->which & ~c->is_real;
  cross_interface_w(scene, c, unreal, &path->within);
  path->within.ignored = path->within.ignored + sel_int_w(unreal, splat_int_w(1), splat_int_w(0));
  path->density = sel_w(unreal, splat_w(R(0.0)), path->density);
  return unreal;
}

/// The same of lanes at their last depth.
SELDOM_FN maskw pass_last_unreal_w(const Scene* scene, Paths_w* path, const Surfaces_w* s, const MaterialRows_w* at,
                                   maskw which) {
  Crossing_w c = crossing_at_w(scene, &path->within, s, which, index_within_w(scene, s, at, which));
  return pass_unreal_w(scene, path, &c);
}
