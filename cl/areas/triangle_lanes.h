// SPDX-License-Identifier: MIT
// Triangle: corner, edge u, edge v, unit normal on the side that emits.

FN AreaPoint_w triangle_point_w(PRIVATE const realw* item, PRIVATE const realw* area, real3w from, realw u, realw v) {
  Real2_w weights = square_to_triangle_w(u, v);
  return flat_point_w(item, area, from, weights.x, weights.y);
}

FN realw triangle_reach_w(PRIVATE const realw* item) { return flat_reach_w(item); }

FN realw triangle_density_w(PRIVATE const realw* item, PRIVATE const realw* area, real3w from, real3w towards,
                            real3w normal) {
  (void)item;
  (void)from;
  return uniform_density_w(area, towards, normal);
}

FN Real2_w triangle_uv_w(GLOBAL const real* uvs, intw item, const AreaPoint_w* p, real side) {
  (void)side;
  return flat_uv_w(uvs, item, p);
}
