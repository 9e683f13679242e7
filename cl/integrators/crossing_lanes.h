// SPDX-License-Identifier: MIT
// Glass that has a priority, where it overlaps other such glass: the index of refraction beside its own is that of what
// is really there. Only the dielectric has a rank, so its parameters are these. One width; no guard.

enum { TRACKED_ETA_w = 6, TRACKED_INSIDE_w = 7 };

/// Puts the indices of what meets there into b, in the lanes of `which` that are at an interface of two such shapes.
FN Crossing_w crossing_of_w(const Scene* scene, const Interfaces_w* within, const Surfaces_w* s, maskw which,
                            Bsdf_w* b) {
  // A program whose materials have fewer parameters has no glass.
  int eta = (int)BSDF_REALS > TRACKED_INSIDE_w ? TRACKED_ETA_w : 0;
  int inside = (int)BSDF_REALS > TRACKED_INSIDE_w ? TRACKED_INSIDE_w : 0;
  Crossing_w c = crossing_at_w(scene, within, s, which, b->p[inside]);
  // Nothing else around: the ratio that the host has rounded once.
  b->p[eta] = sel_w(c.which & c.is_amid, c.ior / c.other, b->p[eta]);
  return c;
}
