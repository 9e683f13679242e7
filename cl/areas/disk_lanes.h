// SPDX-License-Identifier: MIT
// Disk: centre, two perpendicular radii, unit normal on the side that emits.

FN AreaPoint_w disk_point_w(GLOBAL const real* item, GLOBAL const real* area, real3w from, realw u, realw v) {
  Real2_w weights = square_to_disk_w(u, v);
  return flat_point_w(item, area, from, weights.x, weights.y);
}

FN realw disk_density_w(GLOBAL const real* item, GLOBAL const real* area, real3w from, real3w towards, real3w normal) {
  (void)item;
  (void)from;
  return uniform_density_w(area, towards, normal);
}
