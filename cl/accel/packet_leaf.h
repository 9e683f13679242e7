// SPDX-License-Identifier: MIT
// The blocks of a leaf, or of a list, against a packet. One width; no guard.
#include "shapes/packet/packet_bodies_lanes.h"

FN void settle_one_w(const Ray* ray, Nearest* best) {
#if TIER_ROBUST
  nearest_settle(ray, best, LANES);
#else
  (void)ray;
  (void)best;
#endif
}

// The kinds' own files define these; programs without such a kind never call them.
#ifndef PACKET_DISKS
#define PACKET_DISKS no_packet_w
#endif
#ifndef PACKET_CYLINDERS
#define PACKET_CYLINDERS no_packet_w
#endif
FN maskw no_packet_w(Packet_w* p, GLOBAL const real* block, GLOBAL const int* ids, int slot, int kind, maskw active) {
  (void)p;
  (void)block;
  (void)ids;
  (void)slot;
  (void)kind;
  return active;
}

/// The rays of `active` that come near primitives of a block, one by one, for kinds without a body for packets.
#define PACKET_RAYS_ALONE(name)                                                        \
  {                                                                                    \
    uint lanes = bits_w(PACKET_BODY_##name##_w == PACKET_BODY_CYLINDER                 \
                            ? PACKET_CYLINDERS(p, block, ids, b * LANES, kind, active) \
                            : rays_near_w(p, block, ids, kind, active));               \
    if (lanes == 0u) continue;                                                         \
    NearestEach_w each = packet_found_w(p);                                            \
    for (; lanes != 0u; lanes &= lanes - 1u) {                                         \
      int lane = first_bit(lanes);                                                     \
      Nearest best = nearest_of_w(&each, lane);                                        \
      Ray world = ray_of_w(p->rays, lane), ray = ray_of_world(&world);                 \
      if (HAS_TREE)                                                                    \
        meet_blocks_w(scene, &ray, kind, b, 1, FIND_NEAREST, &best);                   \
      else                                                                             \
        name##_block_w(&ray, block, ids, b* LANES, &best);                             \
      settle_one_w(&ray, &best);                                                       \
      packet_put_exact_w(p, lane, &best);                                              \
    }                                                                                  \
  }

/// Tests the blocks of a leaf, or all blocks that its kind lists, against the rays of `active`. group: the row of the
/// group that the packet is in; 0: none.
FN void packet_leaf_w(const Scene* scene, Packet_w* p, GLOBAL const int* group, int reference, maskw active) {
  int kind = leaf_kind(reference), first = leaf_first(reference), count = leaf_blocks(reference);
  GLOBAL const int* row = scene_shape_row(scene, kind);
  if (count == 0) count = row[SHAPE_LISTED];
  if (HAS_GROUPS && group != 0 && leaf_is_list(reference)) {
    first = group[GROUP_LISTED + 2 * kind];
    count = group[GROUP_LISTED + 2 * kind + 1];
  }
  GLOBAL const int* ids = scene->index + row[SHAPE_IDS] + first * LANES;
  GLOBAL const real* geometry = scene->geometry + row[SHAPE_GEOMETRY];
  (void)geometry;  // A scene without shapes.
  (void)p;
  (void)active;
  for (int b = first; b < first + count; ++b, ids += LANES) {
#define SHAPE(name, planes)                                              \
  if (SHAPE_COUNT == 1 || kind == SHAPE_##name) {                        \
    GLOBAL const real* block = geometry + (ulong)b * ((planes)*LANES);   \
    if (PACKET_BODY_##name##_w == PACKET_BODY_TRIANGLE)                  \
      polygon_packet_w(scene, p, block, ids, b* LANES, kind, active, 3); \
    else if (PACKET_BODY_##name##_w == PACKET_BODY_PARALLELOGRAM)        \
      polygon_packet_w(scene, p, block, ids, b* LANES, kind, active, 4); \
    else if (PACKET_BODY_##name##_w == PACKET_BODY_SPHERE)               \
      sphere_packet_w(scene, p, block, ids, b* LANES, kind, active);     \
    else if (PACKET_BODY_##name##_w == PACKET_BODY_PLANE)                \
      plane_packet_w(p, block, ids, b* LANES, kind, active);             \
    else if (PACKET_BODY_##name##_w == PACKET_BODY_DISK)                 \
      PACKET_DISKS(p, block, ids, b* LANES, kind, active);               \
    else                                                                 \
      PACKET_RAYS_ALONE(name)                                            \
  }
#include "shapes/shapes.def"
#undef SHAPE
  }
}
#undef PACKET_RAYS_ALONE
