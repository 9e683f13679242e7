// SPDX-License-Identifier: MIT
// Media that overlap: where a ray is within several shapes with a priority, it is in the medium of the highest one;
// boundaries without a priority are below all of them. The list of shapes is that of glass
// (integrators/interfaces_lanes.h); boundaries that stand apart are in it with an index of refraction of 0, so that
// glass does not know of them. One width; no guard.

FN void sel_interfaces_w(maskw m, const Interfaces_w* a, Interfaces_w* b) {
  for (int k = 0; k < INTERFACES_MOST_w; ++k) {
    b->rank[k] = sel_int_w(m, a->rank[k], b->rank[k]);
    b->instance[k] = sel_int_w(m, a->instance[k], b->instance[k]);
    b->ior[k] = sel_w(m, a->ior[k], b->ior[k]);
    b->medium[k] = sel_int_w(m, a->medium[k], b->medium[k]);
  }
  b->around = sel_int_w(m, a->around, b->around);
}

/// The paths go on along d beyond the surfaces s, which bend nothing: lists are kept.
SELDOM_FN void pass_ranked_w(const Scene* scene, Paths_w* path, const Surfaces_w* s, maskw which, real3w d) {
  Crossing_w c = crossing_at_w(scene, &path->within, s, which & ~s->scatters, splat_w(R(0.0)));
  cross_interface_w(scene, &c, which & goes_through_w(&c, s, d), &path->within);
}

/// The medium in which the paths, whose lists are kept, go on along d from surfaces of shapes with a priority; `media`
/// from others. Paths still have the medium of before. within: the paths' own. straight: lanes that have passed a
/// boundary of media as they came.
SELDOM_FN intw ranked_medium_w(const Scene* scene, Interfaces_w* within, const Surfaces_w* s, maskw straight, real3w d,
                               intw before, intw media) {
  Crossing_w c = crossing_at_w(scene, within, s, ~s->scatters, splat_w(R(0.0)));
  maskw through = c.which & goes_through_w(&c, s, d), enters = through & c.is_entry;
  intw highest = splat_int_w(-1), medium = splat_int_w(MEDIUM_NONE);
  maskw is_first = ~none_w();
  for (int k = 0; k < INTERFACES_MOST_w; ++k) {
    maskw is_more = lt_int_w(highest, within->rank[k]);
    highest = sel_int_w(is_more, within->rank[k], highest);
    medium = sel_int_w(is_more, within->medium[k], medium);
    is_first = is_first & (lt_int_w(within->rank[k], splat_int_w(0)) | is_same_shape_w(within, k, &c));
  }
  within->around = sel_int_w(enters & is_first, before, within->around);
  // What has no priority is below all that has: its boundary counts where those end.
  maskw is_below = straight & ~c.which & ~lt_int_w(highest, splat_int_w(0));
  within->around = sel_int_w(is_below, media, within->around);
  // Behind the last of them is what its shape names, or what was there before.
  intw outside = gather_int_w(scene->index + media_table(scene)[MEDIA_PARTS],
                              s->part * (int)BOUNDARY_INTS + splat_int_w(BOUNDARY_OUTSIDE));
  outside = sel_int_w(nonzero_w(outside - splat_int_w(MEDIUM_SAME)), outside, within->around);
  medium = sel_int_w(lt_int_w(highest, splat_int_w(0)), outside, medium);
  return sel_int_w(c.which, sel_int_w(through, medium, before), sel_int_w(is_below, before, media));
}
