// SPDX-License-Identifier: MIT
// Ray against LANES parallelograms: the four edge functions of its corners A, B, C, D have one sign (edge_lanes.h), so
// faces that share corners neither leak nor hit twice. t comes from the plane of A, B, D.

enum { PACKET_BODY_parallelogram_w = PACKET_BODY_PARALLELOGRAM };
#define parallelogram_SURFACES parallelogram_surfaces_w

/// prim: its reals, LANES apart.
FN Ball parallelogram_ball_w(GLOBAL const real* prim) {
  return ball_around_corners(corner_load(prim, LANES, 0), corner_load(prim, LANES, 1), corner_load(prim, LANES, 2),
                             corner_load(prim, LANES, 3));
}

#if TIER_FAST
#include "shapes/parallelogram/parallelogram_fast_lanes.h"
#else
FN void parallelogram_block_w(const Ray* ray, GLOBAL const real* block, GLOBAL const int* ids, int slot,
                              Nearest* best) {
  ShearedVertex_w a = shear_vertex_w(ray, block);
  ShearedVertex_w b = shear_vertex_w(ray, block + 3 * LANES);
  ShearedVertex_w c = shear_vertex_w(ray, block + 6 * LANES);
  ShearedVertex_w d = shear_vertex_w(ray, block + 9 * LANES);
  realw ab = edge_function_w(a, b), bc = edge_function_w(b, c);
  realw cd = edge_function_w(c, d), da = edge_function_w(d, a);
  realw bd = edge_function_w(b, d), sum = ab + da + bd;
  maskw none = eq_w(sum, splat_w(R(0.0)));  // Polygons without area, such as padding.
  maskw hit = ~(signs_differ_w(ab, bc, cd) | signs_differ_w(bc, cd, da) | none);
  if (ray->departed >= 0 || ray->aim >= 0) hit = hit & ~is_end_w(ids, ray);
  if (!any_w(hit)) return;

  realw z_min = min_w(d.z, min_w(c.z, min_w(b.z, a.z))), z_max = max_w(d.z, max_w(c.z, max_w(b.z, a.z)));
#if TIER_ROBUST
  Polygon_w polygon;
  polygon.at_a = a;
  polygon.at_b = b;
  polygon.at_c = d;
  polygon.of_a = bd;
  polygon.of_b = da;
  polygon.of_c = ab;
  polygon.z_min = z_min;
  polygon.z_max = z_max;
  ApproximateT_w t;
  hit = hit & in_range_approximately_w(ray, best, &polygon, &t);
  if (!any_w(hit)) return;
#else
  realw t = fma_w(ab, d.z, fma_w(da, b.z, bd * a.z)) / sum * splat_w(ray->shear_z);
#if REAL_BITS == 64
  t = within_corners_w(ray, t, block, block + 3 * LANES, block + 6 * LANES, block + 9 * LANES);
#endif
  t = within_range_w(ray, t, z_min, z_max);
  hit = hit & in_range_w(t, ray, best);
#endif

  realw zero = splat_w(R(0.0));
  maskw on_edge = hit & (eq_w(ab, zero) | eq_w(bc, zero) | eq_w(cd, zero) | eq_w(da, zero));
  if (any_w(on_edge)) {
    realw rab = resolved_edge_w(ab, a, b), rbc = resolved_edge_w(bc, b, c);
    realw rcd = resolved_edge_w(cd, c, d), rda = resolved_edge_w(da, d, a);
    hit = hit & ~(on_edge & (signs_differ_w(rab, rbc, rcd) | signs_differ_w(rbc, rcd, rda)));
  }
#if TIER_ROBUST
  take_polygons_w(ray, best, hit, &t, block, ids, 4, SHAPE_parallelogram, slot);
#else
  take_nearest_w(hit, t, ids, -1, SHAPE_parallelogram, slot, best);
#endif
}
#endif
