// SPDX-License-Identifier: MIT
// Triangle: corner, edge u, edge v, unit normal on the side that emits.

FN LANED(AreaPoint)
    LANED(triangle_point)(GLOBAL const real* item, GLOBAL const real* area, real3w from, realw u, realw v) {
  LANED(Real2) weights = LANED(square_to_triangle)(u, v);
  return LANED(flat_point)(item, area, from, weights.x, weights.y);
}

FN realw LANED(triangle_density)(GLOBAL const real* item, GLOBAL const real* area, real3w from, real3w towards,
                                 real3w normal) {
  (void)item;
  (void)from;
  return LANED(uniform_density)(area, towards, normal);
}
