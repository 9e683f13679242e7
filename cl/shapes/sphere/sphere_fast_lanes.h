// SPDX-License-Identifier: MIT
// Ray against LANES spheres as in textbooks: b^2 - 4 a c in world coordinates. It misses distant spheres, and huge ones
// near their surface (docs/numerics.md), in contrast to sphere_lanes.h and sphere_robust_lanes.h.

FN void sphere_block_w(const Ray* ray, GLOBAL const real* block, GLOBAL const int* ids, int slot, Nearest* best) {
  realw fx = splat_w(ray->o.x) - load_w(block);
  realw fy = splat_w(ray->o.y) - load_w(block + LANES);
  realw fz = splat_w(ray->o.z) - load_w(block + 2 * LANES);
  realw r = load_w(block + 3 * LANES);
  realw dx = splat_w(ray->d.x), dy = splat_w(ray->d.y), dz = splat_w(ray->d.z);
  realw a = dx * dx + dy * dy + dz * dz;
  realw b = splat_w(R(2.0)) * (fx * dx + fy * dy + fz * dz);
  realw c = fx * fx + fy * fy + fz * fz - r * r;
  realw discriminant = b * b - splat_w(R(4.0)) * a * c;
  maskw hit = le_w(splat_w(R(0.0)), discriminant);
  if (!any_w(hit)) return;
  realw root = sqrt_w(discriminant), scale = splat_w(R(0.5)) / a;
  realw near = (-b - root) * scale, far = (root - b) * scale;
  realw t = sel_w(le_w(splat_w(ray->t_min), near), near, far);
  // A lamp smaller than the rounding of t would shadow itself.
  hit = hit & nonzero_w(load_int_w(ids) - splat_int_w(ray->aim));
  take_nearest_w(hit & in_range_w(t, ray, best), t, ids, -1, SHAPE_sphere, slot, best);
}
