// SPDX-License-Identifier: MIT
// The nearest hit so far. House law: t < best, or t == best and the smaller scene-wide id. So the answer depends
// neither on the order of blocks nor on the width of lanes nor on the tree. What is in no instance comes before what
// is.
#ifndef STRAHL_CORE_NEAREST_H
#define STRAHL_CORE_NEAREST_H

#include "core/ray.h"
#include "portable.h"

typedef struct {
  real t;
  int id;        ///< Scene-wide: ordered by shape, then primitive.
  int kind;      ///< SHAPE_sphere, ...; -1: nothing hit yet.
  int slot;      ///< block * LANES + lane in the kind's list.
  int instance;  ///< That it was found in; -1: none.
} Nearest;

FN Nearest nearest_none(real t_max) {
  Nearest n;
  n.t = t_max;
  n.id = INT_MAX_ID;
  n.kind = -1;
  n.slot = -1;
  n.instance = -1;
  return n;
}

FN void nearest_take(Nearest* best, real t, int id, int kind, int slot) {
  int is_before = id < best->id;
  if (HAS_INSTANCES) is_before = is_before | (best->instance >= 0);
  if (id >= 0 && (t < best->t || (t == best->t && is_before))) {
    best->t = t;
    best->id = id;
    best->kind = kind;
    best->slot = slot;
    if (HAS_INSTANCES) best->instance = -1;
  }
}

#endif
