// SPDX-License-Identifier: MIT
// Nested and overlapping glass: what a ray is within, shape by shape. Where several shapes that have a priority
// overlap, the one of the highest is there; the surfaces of the others are looked through. J. Schmidt, B. Budge,
// "Simple Nested Dielectrics in Ray Traced Images", Journal of Graphics Tools 7(2), 2002. Shapes without a priority are
// not tracked.
//
// The host turns priorities into ranks, of which no two are alike (scene/layout.h, PART_RANK). Sides are those of the
// geometric normal, so that a ray is out of what it has left, whatever normals it is shaded with. One width; no guard.

enum { LANED(INTERFACES_MOST) = HAS_PRIORITY ? 8 : 1 };

/// What the ray is within, in no order.
typedef struct {
  intw rank[LANED(INTERFACES_MOST)];  ///< -1: free.
  intw instance[LANED(INTERFACES_MOST)];
  realw ior[LANED(INTERFACES_MOST)];
} LANED(Interfaces);

/// A surface of a shape that has a rank.
typedef struct {
  maskw which;     ///< Lanes that are at one.
  maskw is_entry;  ///< The ray comes from outside of that shape.
  maskw is_real;   ///< Something changes there: nothing of a higher rank is around it.
  intw rank, instance;
  realw ior;      ///< Of the shape.
  realw other;    ///< Of what is there without it; undefined where nothing else is.
  maskw is_amid;  ///< Something else is.
} LANED(Crossing);

FN void LANED(interfaces_none)(maskw which, LANED(Interfaces) * within) {
  for (int k = 0; k < LANED(INTERFACES_MOST); ++k) within->rank[k] = sel_int_w(which, splat_int_w(-1), within->rank[k]);
}

FN maskw LANED(is_same_shape)(const LANED(Interfaces) * within, int k, const LANED(Crossing) * c) {
  return ~nonzero_w(within->rank[k] - c->rank) & ~nonzero_w(within->instance[k] - c->instance);
}

FN LANED(Crossing) LANED(crossing_at)(const Scene* scene, const LANED(Interfaces) * within, const LANED(Surfaces) * s,
                                      maskw which, realw ior) {
  LANED(Crossing) c;
  c.rank = LANED(part_entry)(scene, s, PART_RANK);
  c.instance = s->instance;
  c.which = which & ~lt_int_w(c.rank, splat_int_w(0));
  c.is_entry = lt_w(s->facing, splat_w(R(0.0)));
  c.ior = c.other = ior;
  intw highest = splat_int_w(-1);
  for (int k = 0; k < LANED(INTERFACES_MOST); ++k) {
    maskw is_more = lt_int_w(highest, within->rank[k]) & ~LANED(is_same_shape)(within, k, &c);
    highest = sel_int_w(is_more, within->rank[k], highest);
    c.other = sel_w(is_more, within->ior[k], c.other);
  }
  c.is_amid = ~lt_int_w(highest, splat_int_w(0));
  c.is_real = lt_int_w(highest, c.rank);
  return c;
}

/// The lanes of `which` have gone through the surface.
FN void LANED(cross_interface)(const Scene* scene, const LANED(Crossing) * c, maskw which, LANED(Interfaces) * within) {
  maskw enters = c->which & which & c->is_entry, leaves = c->which & which & ~c->is_entry;
  for (int k = 0; k < LANED(INTERFACES_MOST); ++k) {
    within->rank[k] = sel_int_w(leaves & LANED(is_same_shape)(within, k, c), splat_int_w(-1), within->rank[k]);
    maskw takes = enters & lt_int_w(within->rank[k], splat_int_w(0));
    within->rank[k] = sel_int_w(takes, c->rank, within->rank[k]);
    within->instance[k] = sel_int_w(takes, c->instance, within->instance[k]);
    within->ior[k] = sel_w(takes, c->ior, within->ior[k]);
    enters = enters & ~takes;
  }
  // What has found no place will be taken for a way out of nothing: the picture is wrong there, and is told to be.
  if (any_w(enters)) count_events(scene, COUNT_INTERFACES, lanes_among(bits_w(enters)));
}

/// Lanes whose ways on, in the world, are on the other side of the surface.
FN maskw LANED(goes_through)(const LANED(Crossing) * c, const LANED(Surfaces) * s, real3w way) {
  maskw is_inwards = lt_w(dot3_w(way, s->normal), splat_w(R(0.0)));
  return (c->is_entry & is_inwards) | (~c->is_entry & ~is_inwards);
}

FN void LANED(copy_interfaces)(const LANED(Interfaces) * from, int lane, LANED(Interfaces) * to) {
  for (int k = 0; k < LANED(INTERFACES_MOST); ++k) {
    put_int_w(&to->rank[k], lane, get_int_w(&from->rank[k], lane));
    put_int_w(&to->instance[k], lane, get_int_w(&from->instance[k], lane));
    put_w(&to->ior[k], lane, get_w(&from->ior[k], lane));
  }
}
