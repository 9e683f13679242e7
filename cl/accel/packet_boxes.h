// SPDX-License-Identifier: MIT
// Boxes against a packet. First LANES boxes at a time against bounds over all rays, where these are alike: S. Boulos,
// I. Wald, P. Shirley, "Geometric and Arithmetic Culling Methods for Entire Ray Packets", 2006. Then each box that is
// left against every ray, by the operations of slabs_lanes.h. These are monotone, so the bounds lose no box that a ray
// meets. One width; no guard.

/// One axis of LANES boxes, for all rays at once: the entry of the earliest ray and the exit of the latest.
INLINE_FN Interval_w clip_bounds_w(Interval_w t, realw near, realw far, Bounds_w b) {
  realw lo = splat_w(b.inv_lo), hi = splat_w(b.inv_hi), slack = splat_w(b.slack);
  near = near - splat_w(b.o_near);
  far = far - splat_w(b.o_far);
  t.enter = max_w(min_w(fma_w(near, lo, -slack), fma_w(near, hi, -slack)), t.enter);
  t.leave = min_w(max_w(fma_w(far, lo, slack), fma_w(far, hi, slack)), t.leave);
  return t;
}

/// Where rays may be within each of LANES boxes. The rays are alike.
FN Interval_w bounds_within_w(const Packet_w* p, real3w near, real3w far) {
  Interval_w slabs;
  slabs.enter = splat_w(p->first);
  slabs.leave = splat_w(p->last);
  slabs = clip_bounds_w(slabs, near.x, far.x, p->x);
  slabs = clip_bounds_w(slabs, near.y, far.y, p->y);
  return clip_bounds_w(slabs, near.z, far.z, p->z);
}

/// Bit i: some ray may meet box i. The rays are alike.
FN uint may_meet_w(const Packet_w* p, real3w near, real3w far) {
  Interval_w slabs = bounds_within_w(p, near, far);
  return bits_w(le_w(slabs.enter, slabs.leave));
}

/// Where rays may be within each child of the node. The rays are alike.
FN Interval_w bounds_within_children_w(const Packet_w* p, GLOBAL const real* node) {
  int x = p->near_x, y = p->near_y, z = p->near_z;
  real3w near, far;
  near.x = load_w(node + x * LANES);
  near.y = load_w(node + y * LANES);
  near.z = load_w(node + z * LANES);
  far.x = load_w(node + (x ^ 1) * LANES);
  far.y = load_w(node + (y ^ 1) * LANES);
  far.z = load_w(node + (z ^ 1) * LANES);
  return bounds_within_w(p, near, far);
}

/// clip_slab of one box for every ray, of the planes that it meets first and last.
INLINE_FN Interval_w clip_planes_w(Interval_w t, realw near, realw far, realw o, realw inv, realw slack) {
  t.enter = max_w(fma_w(near - o, inv, -slack), t.enter);
  t.leave = min_w(fma_w(far - o, inv, slack), t.leave);
  return t;
}

/// The same; back: lanes that move towards lo.
FN Interval_w clip_each_w(Interval_w t, real lo, real hi, realw o, realw inv, realw slack, maskw back) {
  realw near = sel_w(back, splat_w(hi), splat_w(lo)), far = sel_w(back, splat_w(lo), splat_w(hi));
  return clip_planes_w(t, near, far, o, inv, slack);
}

/// The part of `t` within a box. planes: lo_x, hi_x, lo_y, hi_y, lo_z, hi_z of it, `stride` apart.
INLINE_FN Interval_w within_box_each_w(const Packet_w* p, GLOBAL const real* planes, int stride, Interval_w t) {
  t = clip_each_w(t, planes[0], planes[stride], p->o.x, p->inv.x, p->slack.x, p->back_x);
  t = clip_each_w(t, planes[2 * stride], planes[3 * stride], p->o.y, p->inv.y, p->slack.y, p->back_y);
  return clip_each_w(t, planes[4 * stride], planes[5 * stride], p->o.z, p->inv.z, p->slack.z, p->back_z);
}

/// The same of the rays that can hit something, which are alike.
INLINE_FN Interval_w within_box_alike_w(const Packet_w* p, GLOBAL const real* planes, int stride, Interval_w t) {
  int x = p->near_x, y = p->near_y, z = p->near_z;
  t = clip_planes_w(t, splat_w(planes[x * stride]), splat_w(planes[(x ^ 1) * stride]), p->o.x, p->inv.x, p->slack.x);
  t = clip_planes_w(t, splat_w(planes[y * stride]), splat_w(planes[(y ^ 1) * stride]), p->o.y, p->inv.y, p->slack.y);
  return clip_planes_w(t, splat_w(planes[z * stride]), splat_w(planes[(z ^ 1) * stride]), p->o.z, p->inv.z, p->slack.z);
}

/// The t at which the first ray of `active` enters each child of a node; REAL_MAX: none does. One ray after the other
/// against all children, since that takes the least without a reduction over lanes.
FN realw first_of_each_child_w(const Packet_w* p, GLOBAL const real* node, maskw active) {
  uint back_x = bits_w(p->back_x), back_y = bits_w(p->back_y), back_z = bits_w(p->back_z);
  realw first = splat_w(REAL_MAX);
  for (uint lanes = bits_w(active); lanes != 0u; lanes &= lanes - 1u) {
    int lane = first_bit(lanes);
    int x = (int)(back_x >> lane & 1u), y = 2 + (int)(back_y >> lane & 1u), z = 4 + (int)(back_z >> lane & 1u);
    Interval_w slabs;
    slabs.enter = splat_w(get_w(&p->t_min, lane));
    slabs.leave = splat_w(get_w(&p->bound, lane));
    slabs =
        within_children_w(slabs, node, x, y, z, get3_w(&p->o, lane), get3_w(&p->inv, lane), get3_w(&p->slack, lane));
    first = sel_w(le_w(slabs.enter, slabs.leave), min_w(slabs.enter, first), first);
  }
  return first;
}

/// The rays that meet a child of a node. planes: the planes of the child, LANES apart.
FN maskw meets_child_w(const Packet_w* p, GLOBAL const real* planes) {
  Interval_w slabs;
  slabs.enter = p->t_min;
  slabs.leave = p->bound;
  slabs = is_alike_w(p) ? within_box_alike_w(p, planes, LANES, slabs) : within_box_each_w(p, planes, LANES, slabs);
  return le_w(slabs.enter, slabs.leave);
}

#if TIER_COMPENSATED
/// Where each ray is within a box, lo_x, hi_x, lo_y, hi_y, lo_z, hi_z.
FN Interval_w box_interval_w(const Packet_w* p, PRIVATE const real* box) {
  Interval_w slabs;
  slabs.enter = splat_w(-REAL_MAX);
  slabs.leave = splat_w(REAL_MAX);
  slabs = clip_each_w(slabs, box[0], box[1], p->o.x, p->inv.x, p->slack.x, p->back_x);
  slabs = clip_each_w(slabs, box[2], box[3], p->o.y, p->inv.y, p->slack.y, p->back_y);
  return clip_each_w(slabs, box[4], box[5], p->o.z, p->inv.z, p->slack.z, p->back_z);
}
#endif

#if REAL_BITS == 64
/// t, clamped to the slabs of a box.
FN realw clamped_to_box_w(const Packet_w* p, realw t, PRIVATE const real* box) {
  Interval_w slabs = box_interval_w(p, box);
  t = sel_w(lt_w(t, slabs.enter), slabs.enter, t);
  return sel_w(lt_w(slabs.leave, t), slabs.leave, t);
}
#endif
