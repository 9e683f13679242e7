// SPDX-License-Identifier: MIT
// A ray against the children of a node: TREE_WIDTH of them in lanes, or one after the other where there is one lane.
// One width; no guard.

/// The part of t within LANES children, from the one on whose planes begin at `planes`. x, y, z: numbers of the planes
/// that the ray meets first.
INLINE_FN Interval_w within_children_w(Interval_w t, GLOBAL const real* planes, int x, int y, int z, real3 o, real3 inv,
                                       real3 slack) {
  t = clip_slab_w(t, load_w(planes + x * TREE_WIDTH), load_w(planes + (x ^ 1) * TREE_WIDTH), o.x, inv.x, slack.x);
  t = clip_slab_w(t, load_w(planes + y * TREE_WIDTH), load_w(planes + (y ^ 1) * TREE_WIDTH), o.y, inv.y, slack.y);
  return clip_slab_w(t, load_w(planes + z * TREE_WIDTH), load_w(planes + (z ^ 1) * TREE_WIDTH), o.z, inv.z, slack.z);
}

/// Bit i of the result: the ray meets child i within [t_min, t_max]. t: the t at which each child begins, TREE_WIDTH
/// reals.
FN uint meet_children_w(GLOBAL const real* node, const Ray* ray, real t_max, PRIVATE realw* t) {
  uint met = 0u;
  for (int i = 0; i < TREE_WIDTH; i += LANES) {
    Interval_w slabs;
    slabs.enter = splat_w(ray->t_min);
    slabs.leave = splat_w(t_max);
    slabs = within_children_w(slabs, node + i, ray->near_x, ray->near_y, ray->near_z, ray->o, ray->inv, ray->slack);
    met |= bits_w(le_w(slabs.enter, slabs.leave)) << i;
    t[i / LANES] = slabs.enter;
  }
  return met;
}
