// SPDX-License-Identifier: MIT
// The nearest hit so far. House law: t < best, or t == best and the smaller scene-wide id. So the answer depends
// neither on the order of blocks nor on the width of lanes nor on the tree. Groups have the larger ids: what is in no
// instance comes before what is in one.
#ifndef STRAHL_CORE_NEAREST_H
#define STRAHL_CORE_NEAREST_H

#include "rays/ray.h"
#include "portable.h"

/// What is looked for. ROUGHLY: t of a polygon may come out a little too large. PUT_OFF: the hit may wait, as below.
enum { FIND_NEAREST, FIND_ANY, FIND_NEAREST_APPROXIMATELY, FIND_NEAREST_PUT_OFF };

typedef struct {
  real t;
  int id;        ///< Scene-wide: ordered by shape, then primitive.
  int kind;      ///< SHAPE_sphere, ...; -1: nothing hit yet.
  int slot;      ///< block * LANES + lane in the kind's list.
  int instance;  ///< That it was found in; -1: none.
#if TIER_ROBUST
  int points;        ///< 0: t is exact. Else it waits to be found out (shapes/exact/put_off.h), of a sphere (1: the
                     ///< centre) or a polygon (3, 4 corners), until when it is not below, and t_least not above,
  real t_least;      ///< what it will be.
  real approximate;  ///< What is known of it then,
  GLOBAL const real* prim;  ///< and where to look.
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
