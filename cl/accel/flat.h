// SPDX-License-Identifier: MIT
// Closest hit and any hit over flat lists: every block of every active kind of shape. One width; no guard.
#include "core/candidates.h"
#include "scene/scene.h"
#include "shapes/edge_lanes.h"
#if TIER_COMPENSATED
#include "lanes/double_word.h"
#include "shapes/reach_lanes.h"
#endif
#if TIER_ROBUST
#include "shapes/box_robust_lanes.h"
#include "shapes/polygon_robust_lanes.h"
#include "shapes/quadratic_lanes.h"
#elif TIER_FAST
#include "shapes/moeller_fast_lanes.h"
#endif
#include "shapes/all_lanes.h"

/// stop_at_first: any hit will do.
FN Nearest LANED(walk_lists)(const Scene* scene, const Ray* ray, int stop_at_first) {
  Nearest best = nearest_none(ray->t_max);
  (void)scene;  // A scene without shapes has no lists to walk.
  (void)stop_at_first;
#define SHAPE(name, planes)                                                                                       \
  if (!stop_at_first || best.kind < 0) {                                                                          \
    GLOBAL const int* row = scene_shape_row(scene, SHAPE_##name);                                                 \
    GLOBAL const real* block = scene->geometry + row[SHAPE_GEOMETRY];                                             \
    GLOBAL const int* ids = scene->index + row[SHAPE_IDS];                                                        \
    int blocks = row[SHAPE_BLOCKS];                                                                               \
    for (int b = 0; b < blocks && !(stop_at_first && best.kind >= 0); ++b, block += (planes)*LANES, ids += LANES) \
      LANED(name##_block)(ray, block, ids, b * LANES, &best);                                                     \
  }
#include "shapes/shapes.def"
#undef SHAPE
  return best;
}

FN Nearest LANED(closest_hit)(const Scene* scene, const Ray* ray) { return LANED(walk_lists)(scene, ray, 0); }

/// Is anything hit within [t_min, t_max]?
FN int LANED(any_hit)(const Scene* scene, const Ray* ray) { return LANED(walk_lists)(scene, ray, 1).kind >= 0; }
