// SPDX-License-Identifier: MIT
// LANES rays that traverse the scene together (docs/decisions/0010-packets.md). Each child of a node waits with the t
// at which the first ray enters it. Where few rays are in a subtree they go on alone (packet_alone.h). Hits are those
// of accel/traverse.h. One width; no guard.
#include "accel/packet_bounds.h"
#include "accel/packet_hits.h"
#include "accel/packet_boxes.h"
#include "accel/packet_leaf.h"
#include "accel/packet_alone.h"
#include "accel/packet_instance.h"

#if LANES == 8
#define STACK_ENTRIES STACK_8
#else
#define STACK_ENTRIES STACK_16
#endif

/// Up to so many rays go on alone: of a packet that is alike, and of another one.
enum { FEW_ALIKE_w = 2, FEW_UNLIKE_w = LANES / 4 };

FN int are_few_w(const Packet_w* p, maskw active) {
  return (int)lanes_among(bits_w(active)) <= (is_alike_w(p) ? (int)FEW_ALIKE_w : (int)FEW_UNLIKE_w);
}

/// A leaf of one block with two primitives for each of its rays at most: the packet tests these sooner than the rays go
/// on alone.
FN int is_short_leaf_w(const Scene* scene, int reference, maskw active) {
  int kind = leaf_kind(reference);
  if (reference >= 0 || leaf_blocks(reference) != 1) return 0;
  if (HAS_INSTANCES && kind == SHAPE_COUNT) return 0;
  GLOBAL const int* ids = scene->index + scene_shape_row(scene, kind)[SHAPE_IDS] + leaf_first(reference) * LANES;
  return ids[2 * (int)lanes_among(bits_w(active))] < 0;
}

/// Where any hit will do: ends the rays that have hit something.
FN void packet_stop_w(const Scene* scene, Packet_w* p) {
  packet_settle_w(scene, p);
  maskw done = ~lt_int_w(p->kind, splat_int_w(0));
  p->t = sel_w(done, splat_w(-REAL_MAX), p->t);
  p->bound = min_w(p->t, p->bound);
}

/// The stack: `top` entries, and the t at which the first ray enters each, or less; it orders the children of a node.
/// An entry >= 0 is a child, node * LANES + lane; below 0 it is a leaf or list that every ray is tested against, or
/// NO_REFERENCE, the tree.
typedef struct {
  int top;
  int entry[STACK_ENTRIES];
  real first[STACK_ENTRIES];
} PacketStack_w;

FN void push_list_w(PacketStack_w* stack, int entry) {
  stack->entry[stack->top] = entry;
  stack->first[stack->top++] = -REAL_MAX;
}

/// The tree, and above it the lists, of the world or of a group.
FN void push_lists_w(const Scene* scene, GLOBAL const int* group, PacketStack_w* stack) {
  int root = NO_REFERENCE;
  if (HAS_TREE) root = HAS_INSTANCES && group != 0 ? group[GROUP_ROOT] : scene_root(scene);
  if (root != NO_REFERENCE) push_list_w(stack, NO_REFERENCE);
  for (int kind = SHAPE_COUNT - 1 + HAS_INSTANCES; kind >= 0; --kind) {
    int listed = scene_listed(scene, kind);
    if (HAS_INSTANCES && group != 0) listed = kind == SHAPE_COUNT ? 0 : group[GROUP_LISTED + 2 * kind + 1];
    if (listed != 0) push_list_w(stack, ~kind);
  }
}

/// Pushes the children of a node that rays of `active` may meet, the one that is entered first on top.
FN void push_children_w(const Packet_w* p, GLOBAL const real* nodes, int node, maskw active, PacketStack_w* stack) {
  GLOBAL const real* planes = nodes + (ulong)node * (NODE_PLANES * LANES);
  realw first_of_each;
  uint met;
  if (is_alike_w(p)) {
    Interval_w slabs = bounds_within_children_w(p, planes);
    met = bits_w(le_w(slabs.enter, slabs.leave));
    first_of_each = slabs.enter;
  } else {
    first_of_each = first_of_each_child_w(p, planes, active);
    met = bits_w(lt_w(first_of_each, splat_w(REAL_MAX)));
  }
  // Each goes to its place at once, above those that are entered later and those before it that are entered with it.
  for (uint left = met; left != 0u; left &= left - 1u) {
    int lane = first_bit(left);
    real first = get_w(&first_of_each, lane);
    uint beneath = bits_w(lt_w(splat_w(first), first_of_each));
    beneath |= bits_w(le_w(splat_w(first), first_of_each)) & ((1u << lane) - 1u);
    int at = stack->top + (int)lanes_among(beneath & met);
    stack->entry[at] = node * LANES + lane;
    stack->first[at] = first;
  }
  stack->top += (int)lanes_among(met);
}

/// Traverses all rays of a packet.
FN void packet_walk_w(const Scene* scene, Packet_w* world) {
  GLOBAL const real* nodes = scene->geometry + scene->index[HEADER_NODES];
  GLOBAL const int* children = scene->index + scene->index[HEADER_CHILDREN];
  Packet_w within, *p = world;
  PacketPlace_w place;
  PacketStack_w stack;
  place.instance = -1;
  place.group = 0;
  stack.top = 0;
  push_lists_w(scene, 0, &stack);
  for (;;) {
    int is_within = HAS_INSTANCES && place.instance >= 0;
    if (HAS_INSTANCES && is_within && stack.top == place.floor) {
      packet_leave_w(scene, &place, &within, world);
      p = world;
      if (is_alike_w(p)) p->last = largest_w(p->bound);
      continue;
    }
    if (stack.top == 0) return;
    int entry = stack.entry[--stack.top], reference = entry;
    maskw active;
    if (HAS_TREE && entry >= 0) {
      if (is_alike_w(p) && p->last < stack.first[stack.top]) continue;
      active = meets_child_w(p, nodes + (ulong)(entry / LANES) * (NODE_PLANES * LANES) + entry % LANES);
      reference = children[entry];
    } else {
      active = le_w(p->t_min, p->bound);
    }
    if (!any_w(active)) continue;
    if (HAS_TREE && entry == NO_REFERENCE) reference = is_within ? place.group[GROUP_ROOT] : scene_root(scene);

    int is_list = reference < 0 && leaf_is_list(reference);
    if (HAS_TREE && !(is_within && is_list) && are_few_w(p, active) && !is_short_leaf_w(scene, reference, active)) {
      packet_alone_w(scene, p, reference, active);
    } else if (HAS_TREE && reference >= 0) {
      push_children_w(p, nodes, reference, active, &stack);
      continue;
    } else if (HAS_INSTANCES && leaf_kind(reference) == SHAPE_COUNT) {
      int next = next_instance(scene, reference);
      if (next != NO_REFERENCE) push_list_w(&stack, next);
      if (packet_enter_w(scene, p, reference, active, stack.top, &place, &within)) {
        p = &within;
        push_lists_w(scene, place.group, &stack);
      }
      continue;
    } else {
      packet_leaf_w(scene, p, is_within ? place.group : scene_met(scene), reference, active);
      if (p->stop_at_first) packet_stop_w(scene, p);
    }
    if (is_alike_w(p)) p->last = largest_w(p->bound);
  }
}

/// Finds the hits of LANES rays that are prepared and widened. want: FIND_...
SELDOM_FN NearestEach_w packet_traverse_w(const Scene* scene, Rays_w* rays, int want) {
  Packet_w p;
  packet_none_w(&p);
  if (SHAPE_COUNT == 0 || !packet_make_w(&p, rays, want == FIND_ANY)) return packet_found_w(&p);
  packet_walk_w(scene, &p);
  packet_finish_w(scene, &p, want == FIND_NEAREST_APPROXIMATELY);
  return packet_found_w(&p);
}

#undef STACK_ENTRIES
