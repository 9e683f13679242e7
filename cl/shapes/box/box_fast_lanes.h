// SPDX-License-Identifier: MIT
// Ray against LANES boxes as in textbooks: slabs by fmin and fmax over (plane - o) * (1 / d), T. Kay, J. Kajiya, "Ray
// Tracing Complex Scenes", SIGGRAPH 1986. A ray that lies in a face meets 0 * infinity.

FN void box_block_w(const Ray* ray, GLOBAL const real* block, GLOBAL const int* ids, int slot, Nearest* best) {
  realw x0 = (load_w(block) - splat_w(ray->o.x)) * splat_w(ray->inv.x);
  realw x1 = (load_w(block + LANES) - splat_w(ray->o.x)) * splat_w(ray->inv.x);
  realw y0 = (load_w(block + 2 * LANES) - splat_w(ray->o.y)) * splat_w(ray->inv.y);
  realw y1 = (load_w(block + 3 * LANES) - splat_w(ray->o.y)) * splat_w(ray->inv.y);
  realw z0 = (load_w(block + 4 * LANES) - splat_w(ray->o.z)) * splat_w(ray->inv.z);
  realw z1 = (load_w(block + 5 * LANES) - splat_w(ray->o.z)) * splat_w(ray->inv.z);
  realw enter = fmax(fmax(fmin(x0, x1), fmin(y0, y1)), fmin(z0, z1));
  realw leave = fmin(fmin(fmax(x0, x1), fmax(y0, y1)), fmax(z0, z1));
  realw t = sel_w(le_w(splat_w(ray->t_min), enter), enter, leave);
  take_nearest_w(le_w(enter, leave) & in_range_w(t, ray, best), t, ids, -1, SHAPE_box, slot, best);
}
