// SPDX-License-Identifier: MIT
// Hits whose exact t is put off, robust tier, one lane. A few digits of t mostly decide which of two hits is nearer. So
// the exact t is computed only for hits that are too near to each other, and at the end for the remaining hit, if it is
// needed: for LANES rays at a time where there are as many (settle_lanes.h). The result is the same as with exact t
// throughout. No guard: the width of a primitive's planes is a parameter.

/// A program with one lane settles nothing in lanes, so spheres are decided at once: another copy of their arithmetic
/// would make some compilers of such programs very slow.
#if defined(SCENE_LANES) && SCENE_LANES == 1
enum { SPHERES_WAIT = 0 };
#else
enum { SPHERES_WAIT = 1 };
#endif

/// A candidate that the ray hits: its approximate t, the bounds of its t, and its planes.
typedef struct {
  real approximate, least, most;
  GLOBAL const real* prim;
  int points;  ///< As in hits/nearest.h.
} HitAbout;

/// A sphere that the line certainly passes through. Returns 0 where the hit is not certainly after t_min. k, off,
/// inside: as for sphere_approximately.
FN int sphere_about(const Ray* ray, real k, real off, real inside, HitAbout* at) {
  real about;
  maskw is_after = sphere_approximately_w(ray->t_min, ray->dd_inverse, k, off, inside, &at->approximate, &about);
  at->least = at->approximate - about;
  at->most = at->approximate + about;
  return is_after != 0;
}

/// Defined in settle_kinds.h, which knows the kinds.
ONCE_FN real exact_t(const Ray* ray, real approximate, GLOBAL const real* prim, int points, int stride);

/// From here on t is exact.
FN void nearest_settle(const Ray* ray, Nearest* best, int stride) {
  if (best->points == 0) return;
  best->t = best->t_least = exact_t(ray, best->approximate, best->prim, best->points, stride);
  best->points = 0;
}

FN void nearest_put_off(const Ray* ray, Nearest* best, const HitAbout* at, int stride, int id, int kind, int slot) {
  if (best->t < at->least) return;
  if (ray->t_min <= at->least && at->most < best->t_least) {
    best->t = at->most;
    best->t_least = at->least;
    best->approximate = at->approximate;
    best->prim = at->prim;
    best->points = at->points;
    best->id = id;
    best->kind = kind;
    best->slot = slot;
    if (HAS_INSTANCES) best->instance = -1;
    return;
  }
  for (;;) {  // The best one, if it waits, then the candidate: the arithmetic stands once.
    int waits = best->points != 0;
    real t = exact_t(ray, waits ? best->approximate : at->approximate, waits ? best->prim : at->prim,
                     waits ? best->points : at->points, stride);
    if (!waits) {
      if (ray->t_min <= t) nearest_take(best, t, id, kind, slot);
      return;
    }
    best->t = best->t_least = t;
    best->points = 0;
  }
}
