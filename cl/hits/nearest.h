// SPDX-License-Identifier: MIT
// The nearest hit so far. A hit replaces it if t < best, or if t == best and its scene-wide id is smaller. So the
// result does not depend on the order of blocks, the number of lanes or the tree. Groups have the larger ids: of equal
// t, a primitive outside of instances wins over one within an instance.
#ifndef STRAHL_HITS_NEAREST_H
#define STRAHL_HITS_NEAREST_H

#include "rays/ray.h"
#include "portable.h"

/// What a traversal looks for. APPROXIMATELY: t of a polygon may be a little too large. PUT_OFF: the exact t may be
/// computed later, as below.
enum { FIND_NEAREST, FIND_ANY, FIND_NEAREST_APPROXIMATELY, FIND_NEAREST_PUT_OFF };

typedef struct {
  real t;
  int id;        ///< Scene-wide: ordered by shape, then primitive.
  int kind;      ///< SHAPE_sphere, ...; -1: nothing hit yet.
  int slot;      ///< block * LANES + lane in the kind's list.
  int instance;  ///< The instance in which it was found; -1: none.
#if TIER_ROBUST
  int points;        ///< 0: t is exact. Else the exact t is still to be computed (shapes/exact/put_off.h), for a
                     ///< sphere (1: the centre) or a polygon (3, 4 corners). Until then t is an upper bound of it.
  real t_least;      ///< Until then, a lower bound of the exact t.
  real approximate;  ///< Until then, the approximate t.
  GLOBAL const real* prim;  ///< Until then, the planes of the primitive.
#endif
} Nearest;

FN Nearest nearest_none(real t_max) {
  Nearest n;
  n.t = t_max;
  n.id = INT_MAX_ID;
  n.kind = -1;
  n.slot = -1;
  n.instance = -1;
#if TIER_ROBUST
  n.t_least = t_max;
  n.approximate = t_max;
  n.prim = 0;
  n.points = 0;
#endif
  return n;
}

FN void nearest_take(Nearest* best, real t, int id, int kind, int slot) {
  if (id >= 0 && (t < best->t || (t == best->t && id < best->id))) {
    best->t = t;
    best->id = id;
    best->kind = kind;
    best->slot = slot;
    if (HAS_INSTANCES) best->instance = -1;
#if TIER_ROBUST
    best->points = 0;
    best->t_least = t;
#endif
  }
}

#endif
