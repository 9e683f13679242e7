// SPDX-License-Identifier: MIT
// Parallelogram: corner, edge u, edge v, unit normal on the side that emits.

FN LANED(AreaPoint)
    LANED(parallelogram_point)(GLOBAL const real* item, GLOBAL const real* area, real3w from, realw u, realw v) {
  return LANED(flat_point)(item, area, from, u, v);
}

FN realw LANED(parallelogram_density)(GLOBAL const real* item, GLOBAL const real* area, real3w from, real3w towards,
                                      real3w normal) {
  (void)item;
  (void)from;
  return LANED(uniform_density)(area, towards, normal);
}
