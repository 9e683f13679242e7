// SPDX-License-Identifier: MIT
// Ray against LANES triangles, watertight and single-hit (edge_lanes.h). Zeros are looked for only where a lane is
// hit. t is held within the triangle's own range along the ray. Triangles without area, as padding is, are never
// hit.

enum { LANED(PACKET_BODY_triangle) = PACKET_BODY_TRIANGLE };

/// prim: its reals, LANES apart.
FN Ball LANED(triangle_ball)(GLOBAL const real* prim) {
  real3 p2 = corner_load(prim, LANES, 2);
  return ball_around_corners(corner_load(prim, LANES, 0), corner_load(prim, LANES, 1), p2, p2);
}

#if TIER_FAST
#include "shapes/triangle_fast_lanes.h"
#else
FN void LANED(triangle_block)(const Ray* ray, GLOBAL const real* block, GLOBAL const int* ids, int slot,
                              Nearest* best) {
  LANED(ShearedVertex) a = LANED(shear_vertex)(ray, block);
  LANED(ShearedVertex) b = LANED(shear_vertex)(ray, block + 3 * LANES);
  LANED(ShearedVertex) c = LANED(shear_vertex)(ray, block + 6 * LANES);
  realw ea = LANED(edge_function)(b, c), eb = LANED(edge_function)(c, a), ec = LANED(edge_function)(a, b);
  realw sum = ea + eb + ec;
  maskw hit = ~(LANED(signs_differ)(ea, eb, ec) | eq_w(sum, splat_w(R(0.0))));
  if (ray->left >= 0) hit = hit & ~LANED(is_end)(ids, ray);
  if (!any_w(hit)) return;

  realw z_min = min_w(c.z, min_w(b.z, a.z)), z_max = max_w(c.z, max_w(b.z, a.z));
#if TIER_ROBUST
  LANED(Polygon) polygon;
  polygon.at_a = a;
  polygon.at_b = b;
  polygon.at_c = c;
  polygon.of_a = ea;
  polygon.of_b = eb;
  polygon.of_c = ec;
  polygon.z_min = z_min;
  polygon.z_max = z_max;
  LANED(RoughT) t;
  hit = hit & LANED(in_range_roughly)(ray, best, &polygon, &t);
  if (!any_w(hit)) return;
#else
  realw t = fma_w(ec, c.z, fma_w(eb, b.z, ea * a.z)) / sum * splat_w(ray->shear_z);
#if REAL_BITS == 64
  t = LANED(within_corners)(ray, t, block, block + 3 * LANES, block + 6 * LANES, block + 6 * LANES);
#endif
  t = LANED(within_range)(ray, t, z_min, z_max);
  hit = hit & LANED(in_range)(t, ray, best);
#endif

  realw zero = splat_w(R(0.0));
  maskw on_edge = hit & (eq_w(ea, zero) | eq_w(eb, zero) | eq_w(ec, zero));
  if (any_w(on_edge))
    hit = hit & ~(on_edge & LANED(signs_differ)(LANED(resolved_edge)(ea, b, c), LANED(resolved_edge)(eb, c, a),
                                                LANED(resolved_edge)(ec, a, b)));
#if TIER_ROBUST
  LANED(take_polygons)(ray, best, hit, &t, block, ids, 3, SHAPE_triangle, slot);
#else
  LANED(take_nearest)(hit, t, ids, -1, SHAPE_triangle, slot, best);
#endif
}
#endif
