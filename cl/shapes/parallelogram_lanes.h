// SPDX-License-Identifier: MIT
// Ray against LANES parallelograms: the four edge functions of its corners A, B, C, D have one sign (edge_lanes.h), so
// faces that share corners neither leak nor hit twice. t comes from the plane of A, B, D.

enum { LANED(PACKET_BODY_parallelogram) = PACKET_BODY_PARALLELOGRAM };

/// prim: its reals, LANES apart.
FN Ball LANED(parallelogram_ball)(GLOBAL const real* prim) {
  return ball_around_corners(corner_load(prim, LANES, 0), corner_load(prim, LANES, 1), corner_load(prim, LANES, 2),
                             corner_load(prim, LANES, 3));
}

#if TIER_FAST
#include "shapes/parallelogram_fast_lanes.h"
#else
FN void LANED(parallelogram_block)(const Ray* ray, GLOBAL const real* block, GLOBAL const int* ids, int slot,
                                   Nearest* best) {
  LANED(ShearedVertex) a = LANED(shear_vertex)(ray, block);
  LANED(ShearedVertex) b = LANED(shear_vertex)(ray, block + 3 * LANES);
  LANED(ShearedVertex) c = LANED(shear_vertex)(ray, block + 6 * LANES);
  LANED(ShearedVertex) d = LANED(shear_vertex)(ray, block + 9 * LANES);
  realw ab = LANED(edge_function)(a, b), bc = LANED(edge_function)(b, c);
  realw cd = LANED(edge_function)(c, d), da = LANED(edge_function)(d, a);
  realw bd = LANED(edge_function)(b, d), sum = ab + da + bd;
  maskw none = eq_w(sum, splat_w(R(0.0)));  // Without area, as padding is.
  maskw hit = ~(LANED(signs_differ)(ab, bc, cd) | LANED(signs_differ)(bc, cd, da) | none);
  if (ray->left >= 0) hit = hit & ~LANED(is_end)(ids, ray);
  if (!any_w(hit)) return;

  realw z_min = min_w(d.z, min_w(c.z, min_w(b.z, a.z))), z_max = max_w(d.z, max_w(c.z, max_w(b.z, a.z)));
#if TIER_ROBUST
  LANED(Polygon) polygon;
  polygon.at_a = a;
  polygon.at_b = b;
  polygon.at_c = d;
  polygon.of_a = bd;
  polygon.of_b = da;
  polygon.of_c = ab;
  polygon.z_min = z_min;
  polygon.z_max = z_max;
  LANED(RoughT) t;
  hit = hit & LANED(in_range_roughly)(ray, best, &polygon, &t);
  if (!any_w(hit)) return;
#else
  realw t = fma_w(ab, d.z, fma_w(da, b.z, bd * a.z)) / sum * splat_w(ray->shear_z);
#if REAL_BITS == 64
  t = LANED(within_corners)(ray, t, block, block + 3 * LANES, block + 6 * LANES, block + 9 * LANES);
#endif
  t = LANED(within_range)(ray, t, z_min, z_max);
  hit = hit & LANED(in_range)(t, ray, best);
#endif

  realw zero = splat_w(R(0.0));
  maskw on_edge = hit & (eq_w(ab, zero) | eq_w(bc, zero) | eq_w(cd, zero) | eq_w(da, zero));
  if (any_w(on_edge)) {
    realw rab = LANED(resolved_edge)(ab, a, b), rbc = LANED(resolved_edge)(bc, b, c);
    realw rcd = LANED(resolved_edge)(cd, c, d), rda = LANED(resolved_edge)(da, d, a);
    hit = hit & ~(on_edge & (LANED(signs_differ)(rab, rbc, rcd) | LANED(signs_differ)(rbc, rcd, rda)));
  }
#if TIER_ROBUST
  LANED(take_polygons)(ray, best, hit, &t, block, ids, 4, SHAPE_parallelogram, slot);
#else
  LANED(take_nearest)(hit, t, ids, -1, SHAPE_parallelogram, slot, best);
#endif
}
#endif
