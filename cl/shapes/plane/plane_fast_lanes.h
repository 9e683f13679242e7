// SPDX-License-Identifier: MIT
// Ray against LANES planes in Hesse's form as in textbooks: t = (D - n.o) / (n.d), D = n.P rounded.

FN void plane_block_w(const Ray* ray, GLOBAL const real* block, GLOBAL const int* ids, int slot, Nearest* best) {
  realw nx = load_w(block + 3 * LANES), ny = load_w(block + 4 * LANES), nz = load_w(block + 5 * LANES);
  realw hesse = nx * load_w(block) + ny * load_w(block + LANES) + nz * load_w(block + 2 * LANES);
  realw height = nx * splat_w(ray->o.x) + ny * splat_w(ray->o.y) + nz * splat_w(ray->o.z);
  realw t = (hesse - height) / (nx * splat_w(ray->d.x) + ny * splat_w(ray->d.y) + nz * splat_w(ray->d.z));
  take_nearest_w(in_range_w(t, ray, best), t, ids, -1, SHAPE_plane, slot, best);
}
