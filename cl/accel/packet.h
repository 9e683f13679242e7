// SPDX-License-Identifier: MIT
// LANES coherent rays that traverse the tree together. LANES children of a node at a time are first tested against
// bounds of all rays. Each child that passes is tested against every ray, in lanes, when its turn comes: S. Boulos, I.
// Wald, P. Shirley, "Geometric and Arithmetic Culling Methods for Entire Ray Packets", 2006. The bounds come by the
// monotone operations of slabs_lanes.h, so they lose no child that a ray meets; the second test is those operations
// themselves. Hits are those of accel/traverse.h (docs/decisions/0010-packets.md). One width; no guard.
#include "accel/packet_bounds.h"

#if LANES == 8
#define STACK_ENTRIES STACK_8
#else
#define STACK_ENTRIES STACK_16
#endif

/// One axis of LANES boxes, for all rays at once: the entry of the earliest ray and the exit of the latest.
FN Interval_w clip_bounds_w(Interval_w t, realw near, realw far, Bounds_w b) {
  realw lo = splat_w(b.inv_lo), hi = splat_w(b.inv_hi), slack = splat_w(b.slack);
  near = near - splat_w(b.o_near);
  far = far - splat_w(b.o_far);
  t.enter = max_w(min_w(fma_w(near, lo, -slack), fma_w(near, hi, -slack)), t.enter);
  t.leave = min_w(max_w(fma_w(far, lo, slack), fma_w(far, hi, slack)), t.leave);
  return t;
}

/// Bit i: some ray may meet box i; t[i]: where it begins, at the earliest.
FN uint may_meet_w(const Packet_w* p, real3w near, real3w far, PRIVATE real* t) {
  Interval_w slabs;
  slabs.enter = splat_w(p->first);
  slabs.leave = splat_w(p->last);
  slabs = clip_bounds_w(slabs, near.x, far.x, p->x);
  slabs = clip_bounds_w(slabs, near.y, far.y, p->y);
  slabs = clip_bounds_w(slabs, near.z, far.z, p->z);
  store_w(slabs.enter, t);
  return bits_w(le_w(slabs.enter, slabs.leave));
}

FN uint may_meet_children_w(const Packet_w* p, GLOBAL const real* node, PRIVATE real* t) {
  int x = p->near_x, y = p->near_y, z = p->near_z;
  real3w near, far;
  near.x = load_w(node + x * LANES);
  near.y = load_w(node + y * LANES);
  near.z = load_w(node + z * LANES);
  far.x = load_w(node + (x ^ 1) * LANES);
  far.y = load_w(node + (y ^ 1) * LANES);
  far.z = load_w(node + (z ^ 1) * LANES);
  return may_meet_w(p, near, far, t);
}

/// clip_slab of one box for every ray.
FN Interval_w clip_each_w(Interval_w t, real near, real far, realw o, realw inv, realw slack) {
  t.enter = max_w(fma_w(splat_w(near) - o, inv, -slack), t.enter);
  t.leave = min_w(fma_w(splat_w(far) - o, inv, slack), t.leave);
  return t;
}

/// The rays that meet a child. planes: the planes of the child, TREE_WIDTH apart.
FN maskw meet_child_w(const Packet_w* p, GLOBAL const real* planes) {
  int x = p->near_x, y = p->near_y, z = p->near_z;
  Interval_w slabs;
  slabs.enter = p->t_min;
  slabs.leave = p->bound;
  slabs = clip_each_w(slabs, planes[x * LANES], planes[(x ^ 1) * LANES], p->o.x, p->inv.x, p->slack.x);
  slabs = clip_each_w(slabs, planes[y * LANES], planes[(y ^ 1) * LANES], p->o.y, p->inv.y, p->slack.y);
  slabs = clip_each_w(slabs, planes[z * LANES], planes[(z ^ 1) * LANES], p->o.z, p->inv.z, p->slack.z);
  return le_w(slabs.enter, slabs.leave);
}

#include "shapes/packet/packet_bodies_lanes.h"

FN void settle_one_w(const Ray* ray, Nearest* best) {
#if TIER_ROBUST
  nearest_settle(ray, best, LANES);
#else
  (void)ray;
  (void)best;
#endif
}

/// Traverses one ray alone from a reference on; NO_REFERENCE: through the whole scene.
SELDOM_FN void walk_alone_w(const Scene* scene, const Ray* ray, int start, int stop_at_first, Nearest* best) {
  int want = stop_at_first ? FIND_ANY : FIND_NEAREST;
  if (HAS_TREE)
    *best = walk_w(scene, ray, start, *best, want);
  else
    *best = meet_lists_w(scene, ray, *best, want);
  settle_one_w(ray, best);
}

/// The instances of a leaf, or all listed instances, ray by ray.
FN void packet_instances_w(const Scene* scene, Packet_w* p, int reference, maskw active) {
  packet_settle_w(scene, p);
  NearestEach_w each = packet_open_w(p);
  for (uint lanes = bits_w(active); lanes != 0u; lanes &= lanes - 1u) {
    int lane = first_bit(lanes);
    Ray ray = packet_ray_w(p, lane);
    Nearest best = nearest_of_w(&each, lane);
    if (!(p->stop_at_first && best.kind >= 0)) walk_alone_w(scene, &ray, reference, p->stop_at_first, &best);
    nearest_to_w(&each, lane, best);
  }
  packet_close_w(p, &each);
}

/// Tests the blocks of a leaf, or all blocks that its kind lists, against the rays of `active`.
FN void packet_leaf_w(const Scene* scene, Packet_w* p, int reference, maskw active) {
  uint leaf = (uint)~reference;
  int kind = (int)(leaf & (REFERENCE_MOST_KINDS - 1)), first = (int)(leaf >> REFERENCE_BLOCK);
  int count = (int)(leaf >> REFERENCE_COUNT) & REFERENCE_MOST_BLOCKS;
  GLOBAL const int* row = scene_shape_row(scene, kind);
  if (count == 0) count = row[SHAPE_LISTED];
  GLOBAL const int* ids = scene->index + row[SHAPE_IDS] + first * LANES;
  GLOBAL const real* geometry = scene->geometry + row[SHAPE_GEOMETRY];
  (void)geometry;  // A scene without shapes.
  (void)p;
  (void)active;
  for (int b = first; b < first + count; ++b, ids += LANES) {
#define SHAPE(name, planes)                                              \
  if (SHAPE_COUNT == 1 || kind == SHAPE_##name) {                        \
    GLOBAL const real* block = geometry + (ulong)b * ((planes)*LANES);   \
    if (PACKET_BODY_##name##_w == PACKET_BODY_TRIANGLE) {                \
      polygon_packet_w(scene, p, block, ids, b* LANES, kind, active, 3); \
    } else if (PACKET_BODY_##name##_w == PACKET_BODY_PARALLELOGRAM) {    \
      polygon_packet_w(scene, p, block, ids, b* LANES, kind, active, 4); \
    } else if (PACKET_BODY_##name##_w == PACKET_BODY_SPHERE) {           \
      sphere_packet_w(scene, p, block, ids, b* LANES, kind, active);     \
    } else if (PACKET_BODY_##name##_w == PACKET_BODY_PLANE) {            \
      plane_packet_w(p, block, ids, b* LANES, kind, active);             \
    } else {                                                             \
      uint lanes = bits_w(rays_near_w(p, block, ids, kind, active));     \
      if (lanes == 0u) continue;                                         \
      NearestEach_w each = packet_open_w(p);                             \
      for (; lanes != 0u; lanes &= lanes - 1u) {                         \
        int lane = first_bit(lanes);                                     \
        Nearest best = nearest_of_w(&each, lane);                        \
        Ray world = packet_ray_w(p, lane), ray = ray_of_world(&world);   \
        name##_block_w(&ray, block, ids, b* LANES, &best);               \
        settle_one_w(&ray, &best);                                       \
        nearest_to_w(&each, lane, best);                                 \
      }                                                                  \
      packet_close_w(p, &each);                                          \
    }                                                                    \
  }
#include "shapes/shapes.def"
#undef SHAPE
  }
}

/// Where any hit will do: ends the rays that have hit something.
FN void packet_stop_w(const Scene* scene, Packet_w* p) {
  packet_settle_w(scene, p);
  maskw done = ~lt_int_w(p->kind, splat_int_w(0));
  p->t = sel_w(done, splat_w(-REAL_MAX), p->t);
  p->bound = min_w(p->t, p->bound);
}

/// Pushes the children that are met onto the stack, the nearest on top.
FN void push_children_w(PRIVATE int* waiting, PRIVATE real* waiting_t, PRIVATE int* top, int node, uint met,
                        PRIVATE const real* t) {
  int bottom = *top;
  while (met != 0u) {
    int lane = first_bit(met), at = *top;
    met &= met - 1u;
    while (at > bottom && waiting_t[at - 1] < t[lane]) {
      waiting[at] = waiting[at - 1];
      waiting_t[at] = waiting_t[at - 1];
      --at;
    }
    waiting[at] = node * LANES + lane;
    waiting_t[at] = t[lane];
    ++*top;
  }
}

/// Number of nodes that a packet may enter with only one or two rays before its rays are traced one by one.
enum { PACKET_PATIENCE_w = 24 };

/// Traverses all rays of a packet that packet_make has found coherent. 0: the rays diverge too often; the hits found so
/// far are incomplete.
FN int packet_walk_w(const Scene* scene, Packet_w* p) {
  GLOBAL const real* nodes = scene->geometry + scene->index[HEADER_NODES];
  GLOBAL const int* children = scene->index + scene->index[HEADER_CHILDREN];
  maskw active = le_w(p->t_min, p->t);
  int waiting[STACK_ENTRIES];
  real waiting_t[STACK_ENTRIES];
  int top = 0, patience = PACKET_PATIENCE_w, is_any = PACKET_OF_ANY_RAYS_w;
  // The lists first, kind by kind, then the tree.
  int kind = 0, kinds = SHAPE_COUNT + HAS_INSTANCES, reference = NO_REFERENCE;
  for (;;) {
    if (kind <= kinds) {
      while (kind < kinds && scene_shape_row(scene, kind)[SHAPE_LISTED] == 0) ++kind;
      reference = kind < kinds ? ~kind : (HAS_TREE ? scene->index[HEADER_ROOT] : NO_REFERENCE);
      ++kind;
      if (reference == NO_REFERENCE) return 1;
    }
    if (reference >= 0) {
      real t[LANES];
      uint met = may_meet_children_w(p, nodes + (ulong)reference * (NODE_PLANES * LANES), t);
      push_children_w(waiting, waiting_t, &top, reference, met, t);
    } else {
      if (HAS_INSTANCES && leaf_kind(reference) == SHAPE_COUNT)
        packet_instances_w(scene, p, reference, active);
      else
        packet_leaf_w(scene, p, reference, active);
      if (p->stop_at_first) packet_stop_w(scene, p);
      if (!is_any) p->last = largest_w(p->bound);
      if (is_any ? !any_w(le_w(p->t_min, p->bound)) : p->last < p->first) return 1;
    }
    if (kind <= kinds) continue;
    for (;;) {
      if (top == 0) return 1;
      --top;
      if (p->last < waiting_t[top]) continue;
      int child = waiting[top];
      active = meet_child_w(p, nodes + (ulong)(child / LANES) * (NODE_PLANES * LANES) + child % LANES);
      reference = children[child];
      uint met = bits_w(active), more = met & (met - 1u);
      if (met == 0u) continue;
      if ((more & (more - 1u)) != 0u) {
        if (patience < PACKET_PATIENCE_w) ++patience;
      } else if (--patience == 0) {
        return 0;
      }
      break;
    }
  }
}

/// Finds the hits of LANES rays that are prepared and widened. want: FIND_...
SELDOM_FN NearestEach_w packet_traverse_w(const Scene* scene, Rays_w* rays, int want) {
  Packet_w p;
  NearestEach_w each;
  int is_any = want == FIND_ANY;
  packet_none_w(&p);
  each = packet_open_w(&p);
  if (SHAPE_COUNT == 0) return each;
  int found = packet_make_w(&p, rays, is_any);
  if (found == PACKET_DEAD_w) return each;
  int is_done = 0;
  if (found == PACKET_ALIKE_w) {
    is_done = packet_walk_w(scene, &p);
    packet_finish_w(scene, &p, is_done && want == FIND_NEAREST_APPROXIMATELY);
    each = packet_open_w(&p);
  }
  // Packets of rays that need not be coherent are never split: their program has no traversal for a single ray.
  int never_part = PACKET_OF_ANY_RAYS_w;
  for (int i = 0; i < LANES && !is_done && !never_part; ++i) {
    Nearest best = nearest_of_w(&each, i);
    Ray ray = ray_of_w(rays, i);
    if (best.kind < 0) best = nearest_none(ray.t_max);
    if (!(is_any && best.kind >= 0)) walk_alone_w(scene, &ray, NO_REFERENCE, is_any, &best);
    nearest_to_w(&each, i, best);
  }
  return each;
}

#undef STACK_ENTRIES
