// SPDX-License-Identifier: MIT
// Ray against LANES planes, double precision: t = n.(P - o) / (n.d), the difference exact, both dot products as if in
// three-fold precision, t rounded once. Holds for grazing rays far from the anchor too.
// Parallel rays, those in the plane included, miss: n.d = 0 gives an infinite or NaN t.

FN void plane_block_w(const Ray* ray, GLOBAL const real* block, GLOBAL const int* ids, int slot, Nearest* best) {
  realw nx = load_w(block + 3 * LANES), ny = load_w(block + 4 * LANES), nz = load_w(block + 5 * LANES);
  dw3_w g = two_difference3_w(load_w(block), load_w(block + LANES), load_w(block + 2 * LANES), splat_w(ray->o.x),
                              splat_w(ray->o.y), splat_w(ray->o.z));
  dw_w n_d = real_dot_real3_w(nx, ny, nz, splat_w(ray->d.x), splat_w(ray->d.y), splat_w(ray->d.z));
  realw t = dw_div_w(dot_real3_w(g, nx, ny, nz), n_d).hi;
  take_nearest_w(in_range_w(t, ray, best), t, ids, ray->departed, SHAPE_plane, slot, best);
}
