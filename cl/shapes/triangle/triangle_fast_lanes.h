// SPDX-License-Identifier: MIT
// Ray against LANES triangles as in textbooks (moeller_fast_lanes.h): u > 0, v > 0, u + v < 1.

FN void triangle_block_w(const Ray* ray, GLOBAL const real* block, GLOBAL const int* ids, int slot, Nearest* best) {
  Moeller_w m = moeller_w(ray, block, block + 3 * LANES, block + 6 * LANES);
  realw zero = splat_w(R(0.0));
  maskw hit = lt_w(zero, m.u) & lt_w(zero, m.v) & lt_w(m.u + m.v, splat_w(R(1.0)));
  take_nearest_w(hit & in_range_w(m.t, ray, best), m.t, ids, -1, SHAPE_triangle, slot, best);
}
