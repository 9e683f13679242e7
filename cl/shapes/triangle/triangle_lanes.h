// SPDX-License-Identifier: MIT
// Ray against LANES triangles, watertight and single-hit (edge_lanes.h). Edge functions that are 0 are handled only
// where a lane is hit. t is clamped to the triangle's own range along the ray. Triangles without area, such as padding,
// are never hit.

enum { PACKET_BODY_triangle_w = PACKET_BODY_TRIANGLE };
#define triangle_SURFACES triangle_surfaces_w

/// prim: its reals, LANES apart.
FN Ball triangle_ball_w(GLOBAL const real* prim) {
  real3 p2 = corner_load(prim, LANES, 2);
  return ball_around_corners(corner_load(prim, LANES, 0), corner_load(prim, LANES, 1), p2, p2);
}

#if TIER_FAST
#include "shapes/triangle/triangle_fast_lanes.h"
#else
FN void triangle_block_w(const Ray* ray, GLOBAL const real* block, GLOBAL const int* ids, int slot, Nearest* best) {
  ShearedVertex_w a = shear_vertex_w(ray, block);
  ShearedVertex_w b = shear_vertex_w(ray, block + 3 * LANES);
  ShearedVertex_w c = shear_vertex_w(ray, block + 6 * LANES);
  realw ea = edge_function_w(b, c), eb = edge_function_w(c, a), ec = edge_function_w(a, b);
  realw sum = ea + eb + ec;
  maskw hit = ~(signs_differ_w(ea, eb, ec) | eq_w(sum, splat_w(R(0.0))));
  if (ray->departed >= 0 || ray->aim >= 0) hit = hit & ~is_end_w(ids, ray);
  if (!any_w(hit)) return;

  realw z_min = min_w(c.z, min_w(b.z, a.z)), z_max = max_w(c.z, max_w(b.z, a.z));
#if TIER_ROBUST
  Polygon_w polygon;
  polygon.at_a = a;
  polygon.at_b = b;
  polygon.at_c = c;
  polygon.of_a = ea;
  polygon.of_b = eb;
  polygon.of_c = ec;
  polygon.z_min = z_min;
  polygon.z_max = z_max;
  ApproximateT_w t;
  hit = hit & in_range_approximately_w(ray, best, &polygon, &t);
  if (!any_w(hit)) return;
#else
  realw t = fma_w(ec, c.z, fma_w(eb, b.z, ea * a.z)) / sum * splat_w(ray->shear_z);
#if REAL_BITS == 64
  t = within_corners_w(ray, t, block, block + 3 * LANES, block + 6 * LANES, block + 6 * LANES);
#endif
  t = within_range_w(ray, t, z_min, z_max);
  hit = hit & in_range_w(t, ray, best);
#endif

  realw zero = splat_w(R(0.0));
  maskw on_edge = hit & (eq_w(ea, zero) | eq_w(eb, zero) | eq_w(ec, zero));
  if (any_w(on_edge))
    hit = hit &
          ~(on_edge & signs_differ_w(resolved_edge_w(ea, b, c), resolved_edge_w(eb, c, a), resolved_edge_w(ec, a, b)));
#if TIER_ROBUST
  take_polygons_w(ray, best, hit, &t, block, ids, 3, SHAPE_triangle, slot);
#else
  take_nearest_w(hit, t, ids, -1, SHAPE_triangle, slot, best);
#endif
}
#endif
