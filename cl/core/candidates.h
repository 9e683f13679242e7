// SPDX-License-Identifier: MIT
// Takes the hits of one block into the nearest hit, one width. No guard: include once per LANES.
#include "core/nearest.h"
#include "lanes/lane_names.h"

/// hit: lanes that are hit at t. Padding lanes have id -1 and never count; `excluded` is an id that is not hit.
FN void LANED(take_nearest)(maskw hit, realw t, GLOBAL const int* ids, int excluded, int kind, int slot,
                            Nearest* best) {
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
FN maskw LANED(in_range)(realw t, const Ray* ray, const Nearest* best) {
  return le_w(splat_w(ray->t_min), t) & le_w(t, splat_w(best->t));
}

/// Lanes that hold the primitive that the ray has just left.
FN maskw LANED(is_left)(GLOBAL const int* ids, const Ray* ray) {
  return ~nonzero_w(load_int_w(ids) - splat_int_w(ray->left));
}

/// Lanes that hold a primitive at all.
FN maskw LANED(is_there)(GLOBAL const int* ids) { return nonzero_w(load_int_w(ids) - splat_int_w(-1)); }

/// Of flat primitives: lanes that hold what the ray has just left or ends on.
FN maskw LANED(is_end)(GLOBAL const int* ids, const Ray* ray) {
  return ~(nonzero_w(load_int_w(ids) - splat_int_w(ray->left)) & nonzero_w(load_int_w(ids) - splat_int_w(ray->aim)));
}
