// SPDX-License-Identifier: MIT
// Glass that has a priority, where it overlaps other such glass: the index of refraction beside its own is that of what
// is really there. Only the dielectric has a rank, so its parameters are these. One width; no guard.

enum { LANED(TRACKED_ETA) = 6, LANED(TRACKED_INSIDE) = 7 };

/// Puts the indices of what meets there into b, in the lanes of `which` that are at an interface of two such shapes.
FN LANED(Crossing) LANED(crossing_of)(const Scene* scene, const LANED(Interfaces) * within, const LANED(Surfaces) * s,
                                      maskw which, LANED(Bsdf) * b) {
  // A program whose materials have fewer parameters has no glass.
  int eta = (int)BSDF_REALS > LANED(TRACKED_INSIDE) ? LANED(TRACKED_ETA) : 0;
  int inside = (int)BSDF_REALS > LANED(TRACKED_INSIDE) ? LANED(TRACKED_INSIDE) : 0;
  LANED(Crossing) c = LANED(crossing_at)(scene, within, s, which, b->p[inside]);
  // Nothing else around: the ratio that the host has rounded once.
  b->p[eta] = sel_w(c.which & c.is_amid, c.ior / c.other, b->p[eta]);
  return c;
}
