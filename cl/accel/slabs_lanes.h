// SPDX-License-Identifier: MIT
// Where a ray is within axis-aligned boxes, one width; no guard. The same operations serve the nodes of the tree and,
// where t may err, the primitives in its leaves: subtraction, product and sum are monotone, so a box within a box never
// seems to begin before it (docs/decisions/0008-tree.md). A NaN (a ray in the plane of a face: 0 x infinity) does not
// change the interval. After A. Williams et al., "An Efficient and Robust Ray-Box Intersection Algorithm", JGT 10(1),
// 2005.

typedef struct {
  realw enter, leave;
} Interval_w;

/// One axis: near and far are the planes that the ray meets first and last.
INLINE_FN Interval_w clip_slab_w(Interval_w t, realw near, realw far, real o, real inv, real slack) {
  t.enter = max_w(fma_w(near - splat_w(o), splat_w(inv), splat_w(-slack)), t.enter);
  t.leave = min_w(fma_w(far - splat_w(o), splat_w(inv), splat_w(slack)), t.leave);
  return t;
}

/// t, clamped to the slabs of the box lo ... hi.
FN realw within_slabs_w(const Ray* ray, realw t, realw lo_x, realw hi_x, realw lo_y, realw hi_y, realw lo_z,
                        realw hi_z) {
  Interval_w slabs;
  slabs.enter = splat_w(-REAL_MAX);
  slabs.leave = splat_w(REAL_MAX);
  int x = ray->near_x == 0, y = ray->near_y == 2, z = ray->near_z == 4;
  slabs = clip_slab_w(slabs, x ? lo_x : hi_x, x ? hi_x : lo_x, ray->o.x, ray->inv.x, ray->slack.x);
  slabs = clip_slab_w(slabs, y ? lo_y : hi_y, y ? hi_y : lo_y, ray->o.y, ray->inv.y, ray->slack.y);
  slabs = clip_slab_w(slabs, z ? lo_z : hi_z, z ? hi_z : lo_z, ray->o.z, ray->inv.z, ray->slack.z);
  t = sel_w(lt_w(t, slabs.enter), slabs.enter, t);
  return sel_w(lt_w(slabs.leave, t), slabs.leave, t);
}

/// t, clamped to the slabs of four corners, three planes of LANES reals each.
FN realw within_corners_w(const Ray* ray, realw t, GLOBAL const real* a, GLOBAL const real* b, GLOBAL const real* c,
                          GLOBAL const real* d) {
  realw lo[3], hi[3];
  for (int axis = 0; axis < 3; ++axis) {
    realw pa = load_w(a + axis * LANES), pb = load_w(b + axis * LANES);
    realw pc = load_w(c + axis * LANES), pd = load_w(d + axis * LANES);
    lo[axis] = min_w(pd, min_w(pc, min_w(pb, pa)));
    hi[axis] = max_w(pd, max_w(pc, max_w(pb, pa)));
  }
  return within_slabs_w(ray, t, lo[0], hi[0], lo[1], hi[1], lo[2], hi[2]);
}
