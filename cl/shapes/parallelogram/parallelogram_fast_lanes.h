// SPDX-License-Identifier: MIT
// Ray against LANES parallelograms A, B, C, D by u and v of A, B, D (moeller_fast_lanes.h), both between 0 and 1.

FN void parallelogram_block_w(const Ray* ray, GLOBAL const real* block, GLOBAL const int* ids, int slot,
                              Nearest* best) {
  Moeller_w m = moeller_w(ray, block, block + 3 * LANES, block + 9 * LANES);
  realw zero = splat_w(R(0.0)), one = splat_w(R(1.0));
  maskw hit = lt_w(zero, m.u) & lt_w(zero, m.v) & lt_w(m.u, one) & lt_w(m.v, one);
  take_nearest_w(hit & in_range_w(m.t, ray, best), m.t, ids, -1, SHAPE_parallelogram, slot, best);
}
