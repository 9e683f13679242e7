// SPDX-License-Identifier: MIT
// Ray against LANES triangles, watertight and single-hit (edge_lanes.h). Zeros are looked for only where a lane is
// hit. t is held within the triangle's own range along the ray. Zero-area triangles give a NaN t and are never hit.

#if TIER_FAST
#include "shapes/triangle_fast_lanes.h"
#else
FN void LANED(triangle_block)(const Ray* ray, GLOBAL const real* block, GLOBAL const int* ids, int slot,
                              Nearest* best) {
  LANED(ShearedVertex) a = LANED(shear_vertex)(ray, block);
  LANED(ShearedVertex) b = LANED(shear_vertex)(ray, block + 3 * LANES);
  LANED(ShearedVertex) c = LANED(shear_vertex)(ray, block + 6 * LANES);
  realw ea = LANED(edge_function)(b, c), eb = LANED(edge_function)(c, a), ec = LANED(edge_function)(a, b);
  maskw hit = ~LANED(signs_differ)(ea, eb, ec);
  if (!any_w(hit)) return;

  realw z_min = min_w(c.z, min_w(b.z, a.z)), z_max = max_w(c.z, max_w(b.z, a.z));
#if TIER_ROBUST
  realw t = LANED(polygon_t)(ray, block, block + 3 * LANES, block + 6 * LANES, z_min, z_max);
#else
  realw t = fma_w(ec, c.z, fma_w(eb, b.z, ea * a.z)) / (ea + eb + ec);
  t = sel_w(lt_w(t, z_min), z_min, t);
  t = sel_w(lt_w(z_max, t), z_max, t) * splat_w(ray->shear_z);
#endif
  hit = hit & LANED(in_range)(t, ray, best);

  realw zero = splat_w(R(0.0));
  maskw on_edge = hit & (eq_w(ea, zero) | eq_w(eb, zero) | eq_w(ec, zero));
  if (any_w(on_edge))
    hit = hit & ~(on_edge & LANED(signs_differ)(LANED(resolved_edge)(ea, b, c), LANED(resolved_edge)(eb, c, a),
                                                LANED(resolved_edge)(ec, a, b)));
  LANED(take_nearest)(hit, t, ids, ray->left, SHAPE_triangle, slot, best);
}
#endif
