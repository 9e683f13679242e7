// SPDX-License-Identifier: MIT
// Nested and overlapping glass: the list of shapes that a ray is within. Where several shapes with a priority overlap,
// the medium is that of the highest priority; the surfaces of the others are ignored. J. Schmidt, B. Budge, "Simple
// Nested Dielectrics in Ray Traced Images", Journal of Graphics Tools 7(2), 2002. Shapes without a priority are not
// tracked.
//
// Media go by the same ranks (media/ranked_media_lanes.h); bodies that are nothing but media are in the list for them
// alone.
//
// The host turns priorities into ranks, of which no two are alike (scene/layout.h, PART_RANK). Inside and outside are
// decided by the geometric normal, so that they do not depend on shading normals. One width; no guard.

enum { INTERFACES_MOST_w = HAS_PRIORITY ? 8 : 1 };

/// The shapes that the ray is within, in no order.
typedef struct {
  intw rank[INTERFACES_MOST_w];  ///< -1: free.
  intw instance[INTERFACES_MOST_w];
  realw ior[INTERFACES_MOST_w];  ///< 0: of a body that is nothing but a medium.
  intw ignored;                  ///< Surfaces that the path has ignored.
#if HAS_MEDIA
  intw medium[INTERFACES_MOST_w];
  intw around;  ///< The medium that the ray was in before it entered the first of them.
#endif
} Interfaces_w;

/// A surface of a shape that has a rank.
typedef struct {
  maskw which;     ///< Lanes that are at one.
  maskw is_entry;  ///< The ray comes from outside of that shape.
  maskw is_real;   ///< The medium changes there: no shape of a higher rank is around it.
  intw rank, instance;
  realw ior;      ///< Of the shape.
  realw other;    ///< Of the medium there without the shape; undefined where there is no other shape.
  maskw is_amid;  ///< There is another shape.
#if HAS_MEDIA
  intw medium;  ///< Within the shape.
#endif
} Crossing_w;

FN void interfaces_none_w(maskw which, Interfaces_w* within) {
  for (int k = 0; k < INTERFACES_MOST_w; ++k) within->rank[k] = sel_int_w(which, splat_int_w(-1), within->rank[k]);
  within->ignored = sel_int_w(which, splat_int_w(0), within->ignored);
}

FN maskw is_same_shape_w(const Interfaces_w* within, int k, const Crossing_w* c) {
  return ~nonzero_w(within->rank[k] - c->rank) & ~nonzero_w(within->instance[k] - c->instance);
}

#if HAS_MEDIA
/// Behind the surfaces. What is no boundary of media has none within it.
FN intw medium_inside_w(const Scene* scene, const Surfaces_w* s) {
  GLOBAL const int* parts = scene->index + media_table(scene)[MEDIA_PARTS];
  intw inside = gather_int_w(parts, s->part * (int)BOUNDARY_INTS + splat_int_w(BOUNDARY_INSIDE));
  return sel_int_w(lt_int_w(inside, splat_int_w(0)), splat_int_w(MEDIUM_NONE), inside);
}
#endif

FN Crossing_w crossing_at_w(const Scene* scene, const Interfaces_w* within, const Surfaces_w* s, maskw which,
                            realw ior) {
  Crossing_w c;
  c.rank = part_entry_w(scene, s, PART_RANK);
  c.instance = s->instance;
  c.which = which & ~lt_int_w(c.rank, splat_int_w(0));
  c.is_entry = lt_w(s->facing, splat_w(R(0.0)));
  c.ior = c.other = ior;
  intw highest = splat_int_w(-1);
  for (int k = 0; k < INTERFACES_MOST_w; ++k) {
    maskw is_more = lt_int_w(highest, within->rank[k]) & ~is_same_shape_w(within, k, &c);
#if HAS_MEDIA
    is_more = is_more & lt_w(splat_w(R(0.0)), within->ior[k]);
#endif
    highest = sel_int_w(is_more, within->rank[k], highest);
    c.other = sel_w(is_more, within->ior[k], c.other);
  }
  c.is_amid = ~lt_int_w(highest, splat_int_w(0));
  c.is_real = lt_int_w(highest, c.rank);
#if HAS_MEDIA
  c.medium = medium_inside_w(scene, s);
#endif
  return c;
}

/// The lanes of `which` have gone through the surface.
FN void cross_interface_w(const Scene* scene, const Crossing_w* c, maskw which, Interfaces_w* within) {
  maskw enters = c->which & which & c->is_entry, leaves = c->which & which & ~c->is_entry;
  for (int k = 0; k < INTERFACES_MOST_w; ++k) {
    within->rank[k] = sel_int_w(leaves & is_same_shape_w(within, k, c), splat_int_w(-1), within->rank[k]);
    maskw takes = enters & lt_int_w(within->rank[k], splat_int_w(0));
    within->rank[k] = sel_int_w(takes, c->rank, within->rank[k]);
    within->instance[k] = sel_int_w(takes, c->instance, within->instance[k]);
    within->ior[k] = sel_w(takes, c->ior, within->ior[k]);
#if HAS_MEDIA
    within->medium[k] = sel_int_w(takes, c->medium, within->medium[k]);
#endif
    enters = enters & ~takes;
  }
  // A shape that finds no free place is not tracked, so the picture is wrong there. It is counted, and a warning
  // reports it.
  if (any_w(enters)) count_events(scene, COUNT_INTERFACES, lanes_among(bits_w(enters)));
}

/// Lanes whose new directions, in the world, are on the other side of the surface.
FN maskw goes_through_w(const Crossing_w* c, const Surfaces_w* s, real3w way) {
  maskw is_inwards = lt_w(dot3_w(way, s->normal), splat_w(R(0.0)));
  return (c->is_entry & is_inwards) | (~c->is_entry & ~is_inwards);
}

FN void copy_interfaces_w(const Interfaces_w* from, int lane, Interfaces_w* to) {
  for (int k = 0; k < INTERFACES_MOST_w; ++k) {
    put_int_w(&to->rank[k], lane, get_int_w(&from->rank[k], lane));
    put_int_w(&to->instance[k], lane, get_int_w(&from->instance[k], lane));
    put_w(&to->ior[k], lane, get_w(&from->ior[k], lane));
#if HAS_MEDIA
    put_int_w(&to->medium[k], lane, get_int_w(&from->medium[k], lane));
#endif
  }
  put_int_w(&to->ignored, lane, get_int_w(&from->ignored, lane));
#if HAS_MEDIA
  put_int_w(&to->around, lane, get_int_w(&from->around, lane));
#endif
}
