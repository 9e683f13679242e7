// SPDX-License-Identifier: MIT
// Closest hit and any hit over the whole scene: the lists, then the tree (docs/decisions/0008-tree.md). Where HAS_TREE
// is 0 all primitives are listed, and the program has no tree traversal. One width; no guard. Of the children that a
// ray meets, the nearest is entered first; the others wait on a stack, the nearest on top: I. Wald, C. Benthin, S.
// Boulos, "Getting Rid of Packets", IEEE Symposium on Interactive Ray Tracing, 2008. A child that begins exactly at the
// nearest hit so far is not dropped: among equal t the smallest id wins.
#include "accel/instance.h"
#include "accel/met.h"
#include "accel/packet_kinds.h"
#include "hits/candidates.h"
#include "scene/counters.h"
#include "scene/scene.h"
#include "shapes/polygon/edge_lanes.h"
#if TIER_ROBUST
#include "shapes/exact/exact_scalar.h"
#endif
#if !(TIER_ROBUST && LANES == 1)
#include "accel/slabs_lanes.h"
#if TIER_COMPENSATED
#include "lanes/double_word.h"
#include "math/vec3_lanes.h"
#endif
#if TIER_ROBUST
#include "lanes/wide_lanes.h"
#include "shapes/exact/quadratic_lanes.h"
#include "shapes/plane/plane_t_lanes.h"
#endif
#endif
#if TIER_COMPENSATED
#include "shapes/packet/reach_lanes.h"
#endif
#if TIER_ROBUST
#include "shapes/box/box_robust_lanes.h"
#include "shapes/box/box_t_lanes.h"
#include "shapes/polygon/polygon_robust_lanes.h"
#elif TIER_FAST
#include "shapes/polygon/moeller_fast_lanes.h"
#endif
#include "shapes/ball.h"
#include "shapes/polygon/corners.h"
// These headers need the definitions above.
#include "shapes/all_lanes.h"
#if TIER_ROBUST
#include "shapes/exact/settle_kinds.h"
#endif

/// Number of children of a node. With one lane the program's text defines it.
#ifndef SCALAR_TREE_WIDTH
#define SCALAR_TREE_WIDTH 4
#endif
#if LANES == 1
#define TREE_WIDTH SCALAR_TREE_WIDTH
#else
#define TREE_WIDTH LANES
#endif
#include "accel/node_lanes.h"
#include "accel/prefetch_lanes.h"

#if TREE_WIDTH == 2
#define STACK_ENTRIES STACK_2
#elif TREE_WIDTH == 4
#define STACK_ENTRIES STACK_4
#elif TREE_WIDTH == 8
#define STACK_ENTRIES STACK_8
#else
#define STACK_ENTRIES STACK_16
#endif

/// Returns the nearest of the children that are met; pushes the others, the farthest first. waiting, waiting_t: the
/// stack, references and the t at which they begin, `top` of them. Plain arrays, since PoCL is slower with a struct
/// (docs/decisions/0008-tree.md).
FN int nearest_child_w(const Scene* scene, GLOBAL const real* nodes, PRIVATE int* waiting, PRIVATE real* waiting_t,
                       PRIVATE int* top, GLOBAL const int* children, uint met, PRIVATE const real* t) {
  int lane = first_bit(met);
  met &= met - 1u;
  int nearest = children[lane];
  if (met == 0u) return nearest;
  real nearest_t = t[lane];
  int bottom = *top;
  do {
    lane = first_bit(met);
    met &= met - 1u;
    int child = children[lane];
    real child_t = t[lane];
    prefetch_child_w(scene, nodes, child);
    if (child_t < nearest_t) {
      int other = nearest;
      real other_t = nearest_t;
      nearest = child;
      nearest_t = child_t;
      child = other;
      child_t = other_t;
    }
    int at = *top;
    while (at > bottom && waiting_t[at - 1] < child_t) {
      waiting[at] = waiting[at - 1];
      waiting_t[at] = waiting_t[at - 1];
      --at;
    }
    waiting[at] = child;
    waiting_t[at] = child_t;
    ++*top;
  } while (met != 0u);
  return nearest;
}

#if TIER_ROBUST
FN int body_puts_off_w(int body) {
  if (body == PACKET_BODY_SPHERE) return SPHERES_WAIT;
  return body < PACKET_BODY_PLANE;
}

/// 1: some kind's hits are put off. 0: the program leaves out the arithmetic for it, which some compilers are slow to
/// compile (docs/decisions/0018-soft-fma.md).
enum {
  ANY_PUT_OFF_w = 0
#define SHAPE(name, planes)                                   \
  | (((int)PACKET_BODY_##name##_w < (int)PACKET_BODY_PLANE) & \
     ((int)SPHERES_WAIT | ((int)PACKET_BODY_##name##_w != (int)PACKET_BODY_SPHERE)))
#include "shapes/shapes.def"
#undef SHAPE
};

FN void settle_w(const Ray* ray, Nearest* best) {
  (void)ray;
  (void)best;
  if (ANY_PUT_OFF_w) nearest_settle(ray, best, LANES);
}

/// Whether hits of the kind are put off. Hits of the other kinds get their exact t at once.
FN int puts_off_w(int kind) {
  int answer = 0;
  (void)kind;
#define SHAPE(name, planes) \
  if (kind == SHAPE_##name) answer = body_puts_off_w(PACKET_BODY_##name##_w);
#include "shapes/shapes.def"
#undef SHAPE
  return answer;
}
#endif

/// What a leaf calls: not inlined in the tree's traversal, where the bodies of several kinds would take the registers
/// that it needs (docs/decisions/0017-once.md).
#define LEAF_FN_0 FN
#define LEAF_FN_1 ONCE_FN
#define LEAF_FN LANED_EXPAND(LEAF_FN, HAS_TREE)

/// Tests `count` blocks of a kind, from `first` on.
LEAF_FN void meet_blocks_w(const Scene* scene, const Ray* ray, int kind, int first, int count, int want,
                           Nearest* best) {
  GLOBAL const int* row = scene_shape_row(scene, kind);
  GLOBAL const int* ids = scene->index + row[SHAPE_IDS] + first * LANES;
  GLOBAL const real* geometry = scene->geometry + row[SHAPE_GEOMETRY];
  prefetch_ints_w(ids);
  if (HAS_COUNT_RAYS) count_events(scene, COUNT_PRIMITIVES, primitives_among(ids, count * LANES));
  (void)ray;  // A scene without shapes.
  (void)geometry;
#if TIER_ROBUST
  if (SHAPE_COUNT > 1 && want != FIND_ANY && !puts_off_w(kind)) settle_w(ray, best);
#endif
  for (int b = first; b < first + count && !(want == FIND_ANY && best->kind >= 0); ++b, ids += LANES) {
#define SHAPE(name, planes)                                            \
  if (SHAPE_COUNT == 1 || kind == SHAPE_##name) {                      \
    GLOBAL const real* block = geometry + (ulong)b * ((planes)*LANES); \
    name##_block_w(ray, block, ids, b* LANES, best);                   \
  }
#include "shapes/shapes.def"
#undef SHAPE
  }
}

/// Tests the blocks of a leaf, or all blocks that the kind lists in that place.
FN void meet_leaf_w(const Scene* scene, const Ray* ray, const Place* place, int reference, int want, Nearest* best) {
  int kind = leaf_kind(reference), first = leaf_first(reference), count = leaf_blocks(reference);
  GLOBAL const int* row = scene_shape_row(scene, kind);
  if (count == 0) count = row[SHAPE_LISTED];
  GLOBAL const int* group = scene_met(scene);
  if (HAS_INSTANCES && is_within(place)) group = place->group;
  if (HAS_GROUPS && group != 0 && leaf_is_list(reference)) {
    first = group[GROUP_LISTED + 2 * kind];
    count = group[GROUP_LISTED + 2 * kind + 1];
  }
  meet_blocks_w(scene, ray, kind, first, count, want, best);
}

/// Tests all listed primitives, for scenes without a tree. A function of its own, because what the tree traversal
/// prepares for nodes is a large cost in small scenes (docs/decisions/0014-effects.md). `best` is the nearest hit so
/// far.
FN Nearest meet_lists_w(const Scene* scene, const Ray* ray, Nearest best, int want) {
  Place place;
  place.instance = -1;
  (void)scene;  // A scene without shapes.
  (void)ray;
  (void)want;
#define SHAPE(name, planes) \
  if (scene_listed(scene, SHAPE_##name) > 0) meet_leaf_w(scene, ray, &place, ~SHAPE_##name, want, &best);
#include "shapes/shapes.def"
#undef SHAPE
  return best;
}

/// Traverses from a reference on; NO_REFERENCE: the whole scene. `best` is the nearest hit so far. world: widened by
/// ray_widen or widen_rays. want: FIND_...; the last digits of t may be put off.
FN Nearest walk_w(const Scene* scene, const Ray* world, int start, Nearest best, int want) {
  if (SHAPE_COUNT == 0) return best;
  Ray ray = ray_of_world(world);
  Place place;
  place.instance = -1;
  GLOBAL const real* nodes = scene->geometry + scene->index[HEADER_NODES];
  GLOBAL const int* children = scene->index + scene->index[HEADER_CHILDREN];
  int waiting[STACK_ENTRIES];
  real waiting_t[STACK_ENTRIES];
  int top = 0, reference = start;
  if (start == NO_REFERENCE) {
    reference = scene_root(scene);
#define SHAPE(name, planes)                    \
  if (scene_listed(scene, SHAPE_##name) > 0) { \
    if (reference != NO_REFERENCE) {           \
      waiting[top] = reference;                \
      waiting_t[top++] = ray.t_min;            \
    }                                          \
    reference = ~SHAPE_##name;                 \
  }
#include "shapes/shapes.def"
#undef SHAPE
    if (HAS_INSTANCES && scene_listed(scene, SHAPE_COUNT) > 0) {
      if (reference != NO_REFERENCE) {
        waiting[top] = reference;
        waiting_t[top++] = ray.t_min;
      }
      reference = ~SHAPE_COUNT;
    }
    if (reference == NO_REFERENCE) return best;
  }

  for (;;) {
    while (reference >= 0) {
      realw t[TREE_WIDTH / LANES];
      if (HAS_COUNT_RAYS) count_event(scene, COUNT_NODES);
      GLOBAL const real* node = nodes + (ulong)reference * (NODE_PLANES * TREE_WIDTH);
      prefetch_ints_w(children + (ulong)reference * TREE_WIDTH);
      uint met = meet_children_w(node, &ray, best.t, t);
      if (met == 0u) break;
      reference = nearest_child_w(scene, nodes, waiting, waiting_t, &top, children + (ulong)reference * TREE_WIDTH, met,
                                  (PRIVATE const real*)t);
    }
    if (HAS_INSTANCES && reference < 0 && leaf_kind(reference) == SHAPE_COUNT) {
      int next = next_instance(scene, reference);
      if (next != NO_REFERENCE) {
        waiting[top] = next;
        waiting_t[top++] = ray.t_min;
      }
#if TIER_ROBUST
      settle_w(&ray, &best);
#endif
      if (enter_instance(scene, world, reference, top, &place, &ray, &best)) {
        if (place.group[GROUP_ROOT] != NO_REFERENCE) {
          waiting[top] = place.group[GROUP_ROOT];
          waiting_t[top++] = ray.t_min;
        }
#define SHAPE(name, planes)                                   \
  if (place.group[GROUP_LISTED + 2 * SHAPE_##name + 1] > 0) { \
    waiting[top] = ~SHAPE_##name;                             \
    waiting_t[top++] = ray.t_min;                             \
  }
#include "shapes/shapes.def"
#undef SHAPE
      }
    } else if (reference < 0) {
      meet_leaf_w(scene, &ray, &place, reference, want, &best);
      if (want == FIND_ANY && best.kind >= 0) break;
    }
    do {
      if (HAS_INSTANCES && is_within(&place) && top == place.floor) {
#if TIER_ROBUST
        settle_w(&ray, &best);
#endif
        leave_instance(&place, &ray, &best);
        ray = ray_of_world(world);
      }
      if (top == 0) return best;
      --top;
    } while (best.t < waiting_t[top]);
    reference = waiting[top];
  }
  return best;
}

FN Nearest traverse_w(const Scene* scene, const Ray* ray, int want) {
  Nearest best = nearest_none(ray->t_max);
  if (HAS_TREE)
    best = walk_w(scene, ray, NO_REFERENCE, best, want);
  else
    best = meet_lists_w(scene, ray, best, want);
#if TIER_ROBUST
  int is_round = best.points == 1;
  if (want == FIND_NEAREST || (want == FIND_NEAREST_APPROXIMATELY && is_round)) settle_w(ray, &best);
#endif
  return best;
}

FN Ray widened_w(const Scene* scene, const Ray* given) {
  Ray ray = *given;
  // The widening matters only for the boxes of nodes and instances.
  int is_walked = HAS_INSTANCES || scene_root(scene) != NO_REFERENCE;
  if (HAS_TREE && is_walked) ray_widen(&ray, scene_reach(scene));
  return ray;
}

/// As traverse_w, not inlined, for programs that trace rays in several places.
ONCE_FN Nearest traverse_once_w(const Scene* scene, const Ray* ray, int want) { return traverse_w(scene, ray, want); }

/// 1: the program has a tree traversal, or lists of more than two kinds. Then it is worth a call, because the traversal
/// is a large part of the program (docs/decisions/0017-once.md). A constant: compilers that do not optimise before they
/// inline (rusticl's) keep both sides of an `if` over a function's result.
enum { IS_TRAVERSAL_LARGE_w = (HAS_TREE != 0) | (SHAPE_COUNT > 2) };

/// want: FIND_...
FN Nearest closest_hit_w(const Scene* scene, const Ray* given, int want) {
  Ray ray = widened_w(scene, given);
  if (IS_TRAVERSAL_LARGE_w) return traverse_once_w(scene, &ray, want);
  return traverse_w(scene, &ray, want);
}

/// Is anything hit within [t_min, t_max]?
FN int any_hit_w(const Scene* scene, const Ray* given) { return closest_hit_w(scene, given, FIND_ANY).kind >= 0; }

#undef STACK_ENTRIES
#undef TREE_WIDTH
