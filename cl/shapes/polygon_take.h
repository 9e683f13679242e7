// SPDX-License-Identifier: MIT
// A flat polygon taken as the nearest hit, robust tier, one lane. Which of two is nearer is mostly plain from their t
// to a few digits, so the exact t is found out for those that are too near to each other, and in the end for the one
// that is left, if anybody asks. The answer is that of exact t throughout. No guard: the width of its planes is a
// parameter.

/// corners: 3 or 4; planes `stride` apart.
FN real polygon_exact_t(const Ray* ray, real rough, GLOBAL const real* prim, int corners, int stride) {
  GLOBAL const real* c = prim + 6 * stride;
  real t;
  if (corners == 3 && triangle_t(ray, rough, prim, prim + 3 * stride, c, stride, &t)) return t;
  return polygon_t(ray, rough, prim, prim + 3 * stride, corners == 3 ? c : prim + 9 * stride, c, stride);
}

/// From here on t is exact.
FN void nearest_settle(const Ray* ray, Nearest* best, int stride) {
  if (best->corners == 0) return;
  best->t = best->t_least = polygon_exact_t(ray, best->rough, best->prim, best->corners, stride);
  best->corners = 0;
}

/// Where polygons stand among other kinds.
ONCE_FN void nearest_settle_once(const Ray* ray, Nearest* best, int stride) { nearest_settle(ray, best, stride); }

/// Of a candidate that the ray meets: t roughly, between what bounds it lies, and where to look.
typedef struct {
  real rough, least, most;
  GLOBAL const real* prim;
  int corners;
} PolygonT;

/// The best so far is exact, or of the same kind.
FN void polygon_take(const Ray* ray, Nearest* best, const PolygonT* at, int stride, int id, int kind, int slot) {
  if (best->t < at->least) return;
  if (ray->t_min <= at->least && at->most < best->t_least) {
    best->t = at->most;
    best->t_least = at->least;
    best->rough = at->rough;
    best->prim = at->prim;
    best->corners = at->corners;
    best->id = id;
    best->kind = kind;
    best->slot = slot;
    if (HAS_INSTANCES) best->instance = -1;
    return;
  }
  for (;;) {  // The best one, if it waits, then the candidate: the arithmetic stands once.
    int waits = best->corners != 0;
    real t = polygon_exact_t(ray, waits ? best->rough : at->rough, waits ? best->prim : at->prim, at->corners, stride);
    if (!waits) {
      if (ray->t_min <= t) nearest_take(best, t, id, kind, slot);
      return;
    }
    best->t = best->t_least = t;
    best->corners = 0;
  }
}
