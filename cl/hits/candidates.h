// SPDX-License-Identifier: MIT
// Merges the hits of one block into the nearest hit, one width. No guard: include once per LANES.
#include "hits/nearest.h"
#include "lanes/lane_names.h"

/// hit: lanes that are hit at t. Padding lanes have id -1 and never count; `excluded` is an id that is not hit.
FN void take_nearest_w(maskw hit, realw t, GLOBAL const int* ids, int excluded, int kind, int slot, Nearest* best) {
  uint candidates = bits_w(hit);
  real ts[LANES];
  store_w(t, ts);
  while (candidates != 0u) {
    int lane = first_bit(candidates);
    candidates &= candidates - 1u;
    int id = ids[lane];
    if (id != excluded) nearest_take(best, ts[lane], id, kind, slot + lane);
  }
}

/// Lanes within [t_min, best so far].
FN maskw in_range_w(realw t, const Ray* ray, const Nearest* best) {
  return le_w(splat_w(ray->t_min), t) & le_w(t, splat_w(best->t));
}

/// Lanes that hold the primitive that the ray has just left.
FN maskw is_departed_w(GLOBAL const int* ids, const Ray* ray) {
  return ~nonzero_w(load_int_w(ids) - splat_int_w(ray->departed));
}

/// Lanes that hold a primitive at all.
FN maskw is_there_w(GLOBAL const int* ids) { return nonzero_w(load_int_w(ids) - splat_int_w(-1)); }

/// For primitives that a ray which has left them does not hit again: lanes that hold another one.
FN maskw is_another_w(GLOBAL const int* ids, const Ray* ray) { return is_there_w(ids) & ~is_departed_w(ids, ray); }

/// For flat primitives: lanes that hold the primitive that the ray has just left or ends on.
FN maskw is_end_w(GLOBAL const int* ids, const Ray* ray) {
  return ~(nonzero_w(load_int_w(ids) - splat_int_w(ray->departed)) &
           nonzero_w(load_int_w(ids) - splat_int_w(ray->aim)));
}
