// SPDX-License-Identifier: MIT
// Rays against open cylinders, one of each a lane: the sphere's stable form (sphere_lanes.h) for f x v and d x v, v the
// axis, whose products keep the sign of what is parallel to it; then each root's place along the axis. v is a unit
// vector that was rounded; the rounded one is taken as exact, so the mantle is |f x v| = r |v|. A ray parallel to the
// axis misses. The cylinder just left: the other root, -2 (f.d) / (d.d). One width; no guard.

/// A cylinder a lane.
typedef struct {
  real3w foot, axis;
  realw length, r;
} Cylinders_w;

#if TIER_ROBUST
#include "shapes/cylinder/cylinder_robust_lanes.h"
#else
typedef struct {
  maskw which;  ///< Lanes that hit,
  realw t;      ///< and where.
} CylinderHits_w;

#if TIER_FAST
#include "shapes/cylinder/cylinder_fast_lanes.h"
#else
/// The lanes of `which` that hit, and those of `departed` that hit the cylinder that they have left. A ray and a
/// cylinder a lane.
FN CylinderHits_w cylinder_hits_w(real3w o, real3w way, const Cylinders_w* cylinder, realw t_min, maskw which,
                                  maskw departed) {
  CylinderHits_w hits;
  real3w g = sub3_w(o, cylinder->foot), v = cylinder->axis;
  realw vv = fma_w(v.z, v.z, fma_w(v.y, v.y, v.x * v.x));
  realw fx = difference_of_products_w(g.y, v.z, g.z, v.y), dx = difference_of_products_w(way.y, v.z, way.z, v.y);
  realw fy = difference_of_products_w(g.z, v.x, g.x, v.z), dy = difference_of_products_w(way.z, v.x, way.x, v.z);
  realw fz = difference_of_products_w(g.x, v.y, g.y, v.x), dz = difference_of_products_w(way.x, v.y, way.y, v.x);

  realw a = fma_w(dz, dz, fma_w(dy, dy, dx * dx));
  realw b = fma_w(fz, dz, fma_w(fy, dy, fx * dx));
  realw k = b / a;
  realw lx = fma_w(-k, dx, fx), ly = fma_w(-k, dy, fy), lz = fma_w(-k, dz, fz);
  realw r2 = cylinder->r * cylinder->r * vv;
  realw d = r2 - fma_w(lz, lz, fma_w(ly, ly, lx * lx));
  realw zero = splat_w(R(0.0)), length = cylinder->length;
  maskw hit = which & le_w(zero, d);
  hits.which = hit;
  hits.t = zero;
  if (!any_w(hit | departed)) return hits;

  realw o_along = fma_w(g.z, v.z, fma_w(g.y, v.y, g.x * v.x)) / vv;
  realw d_along = fma_w(way.z, v.z, fma_w(way.y, v.y, way.x * v.x)) / vv;
  realw root = sqrt_w(a * max_w(d, zero));
  realw q = -b - sel_w(lt_w(b, zero), -root, root);
  realw c = fma_w(fz, fz, fma_w(fy, fy, fx * fx)) - r2;
  realw t0 = q / a, t1 = c / q;
  realw near = sel_w(lt_w(t1, t0), t1, t0), far = sel_w(lt_w(t1, t0), t0, t1);
  realw near_along = fma_w(near, d_along, o_along);
  maskw near_hit = le_w(t_min, near) & le_w(zero, near_along) & le_w(near_along, length);
  realw t = sel_w(near_hit, near, far);

  realw other = splat_w(-R(2.0)) * k;
  t = sel_w(departed, other, t);
  realw along = fma_w(t, d_along, o_along);
  hits.which = ((hit & ~departed) | (departed & lt_w(zero, other))) & le_w(zero, along) & le_w(along, length);
  hits.t = t;
  return hits;
}
#endif

FN realw cylinder_about_w(const CylinderHits_w* hits) { return hits->t; }

/// As in cylinder_robust_lanes.h; here it is known already.
FN realw cylinder_t_w(real3w o, real3w d, const Cylinders_w* cylinder, const CylinderHits_w* hits, maskw departed) {
  (void)o;
  (void)d;
  (void)cylinder;
  (void)departed;
  return hits->t;
}
#endif
