// SPDX-License-Identifier: MIT
// Triangle: corner, edge u, edge v, unit normal on the side that emits.

FN LANED(AreaPoint)
    LANED(triangle_point)(GLOBAL const real* item, GLOBAL const real* area, real3w from, realw u, realw v) {
  LANED(Real2) weights = LANED(square_to_triangle)(u, v);
  real3w edge_u = splat3_w(load3(item + 3)), edge_v = splat3_w(load3(item + 6));
  real3w position = add3_w(fma3_w(weights.x, edge_u, scale3_w(weights.y, edge_v)), splat3_w(load3(item)));
  return LANED(uniform_point)(area, from, position, splat3_w(load3(item + 9)));
}

FN realw LANED(triangle_density)(GLOBAL const real* item, GLOBAL const real* area, real3w from, real3w towards,
                                 real3w normal) {
  (void)item;
  (void)from;
  return LANED(uniform_density)(area, towards, normal);
}
