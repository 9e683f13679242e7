// SPDX-License-Identifier: MIT
// A ray against the children of a node: TREE_WIDTH of them in lanes, or one after the other where there is one lane.
// One width; no guard.

/// Bit i of the result: the ray meets child i within [t_min, t_max]. t: the t at which each child begins, TREE_WIDTH
/// reals.
FN uint meet_children_w(GLOBAL const real* node, const Ray* ray, real t_max, PRIVATE realw* t) {
  uint met = 0u;
  for (int i = 0; i < TREE_WIDTH; i += LANES) {
    Interval_w slabs;
    slabs.enter = splat_w(ray->t_min);
    slabs.leave = splat_w(t_max);
    GLOBAL const real* planes = node + i;
    int x = ray->near_x, y = ray->near_y, z = ray->near_z;
    slabs = clip_slab_w(slabs, load_w(planes + x * TREE_WIDTH), load_w(planes + (x ^ 1) * TREE_WIDTH), ray->o.x,
                        ray->inv.x, ray->slack.x);
    slabs = clip_slab_w(slabs, load_w(planes + y * TREE_WIDTH), load_w(planes + (y ^ 1) * TREE_WIDTH), ray->o.y,
                        ray->inv.y, ray->slack.y);
    slabs = clip_slab_w(slabs, load_w(planes + z * TREE_WIDTH), load_w(planes + (z ^ 1) * TREE_WIDTH), ray->o.z,
                        ray->inv.z, ray->slack.z);
    met |= bits_w(le_w(slabs.enter, slabs.leave)) << i;
    t[i / LANES] = slabs.enter;
  }
  return met;
}
