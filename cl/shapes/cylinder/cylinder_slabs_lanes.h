// SPDX-License-Identifier: MIT
// Where a ray that has left a cylinder may hit it again, one width; no guard. The hit must lie within the slabs that
// the tree uses: if the origin is not on the cylinder, the root may lie outside of them. The box is that of the host
// without its margin for rounding.

/// Lanes whose t lies within the slabs of their cylinders.
FN maskw within_cylinder_slabs_w(const Ray* ray, GLOBAL const real* block, realw t) {
  realw length = load_w(block + 6 * LANES), r = load_w(block + 7 * LANES), lo[3], hi[3];
  for (int i = 0; i < 3; ++i) {
    int j = i == 2 ? 0 : i + 1, k = j == 2 ? 0 : j + 1;
    realw u_j = load_w(block + (3 + j) * LANES), u_k = load_w(block + (3 + k) * LANES);
    realw from = load_w(block + i * LANES), to = fma_w(load_w(block + (3 + i) * LANES), length, from);
    realw reach = r * sqrt_w(fma_w(u_j, u_j, u_k * u_k));
    lo[i] = min_w(to, from) - reach;
    hi[i] = max_w(to, from) + reach;
  }
  return eq_w(within_slabs_w(ray, t, lo[0], hi[0], lo[1], hi[1], lo[2], hi[2]), t);
}
