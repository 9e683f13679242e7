// SPDX-License-Identifier: MIT
// The nearest hit so far. House law: t < best, or t == best and the smaller scene-wide id. So the answer depends
// neither on the order of blocks nor on the width of lanes nor on the tree.
#ifndef STRAHL_CORE_NEAREST_H
#define STRAHL_CORE_NEAREST_H

#include "core/ray.h"
#include "portable.h"

typedef struct {
  real t;
  int id;    ///< Scene-wide: ordered by shape, then primitive.
  int kind;  ///< SHAPE_sphere, ...; -1: nothing hit yet.
  int slot;  ///< block * LANES + lane in the kind's list.
} Nearest;

FN Nearest nearest_none(real t_max) {
  Nearest n;
  n.t = t_max;
  n.id = INT_MAX_ID;
  n.kind = -1;
  n.slot = -1;
  return n;
}

FN void nearest_take(Nearest* best, real t, int id, int kind, int slot) {
  if (id >= 0 && (t < best->t || (t == best->t && id < best->id))) {
    best->t = t;
    best->id = id;
    best->kind = kind;
    best->slot = slot;
  }
}

#endif
