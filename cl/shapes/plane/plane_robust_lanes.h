// SPDX-License-Identifier: MIT
// Ray against LANES planes, robust tier: t = n.(P - o) / (n.d), correctly rounded, at grazing angles and far from the
// anchor too. Parallel rays, those in the plane included, miss: they have a NaN. The plane that a ray has left is not
// asked for: its t is 0 or so, which only exact arithmetic tells from t_min.

FN void plane_block_w(const Ray* ray, GLOBAL const real* block, GLOBAL const int* ids, int slot, Nearest* best) {
  realw t = plane_t_w(splat3_w(ray->o), splat3_w(ray->d), load_planes3_w(block), load_planes3_w(block + 3 * LANES),
                      splat_w(ray->t_min), splat_w(best->t), is_another_w(ids, ray));
  take_nearest_w(in_range_w(t, ray, best), t, ids, ray->departed, SHAPE_plane, slot, best);
}
