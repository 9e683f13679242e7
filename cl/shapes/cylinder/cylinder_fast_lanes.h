// SPDX-License-Identifier: MIT
// Ray against LANES open cylinders as in textbooks: b^2 - 4 a c across the axis, in world coordinates.

FN void cylinder_block_w(const Ray* ray, GLOBAL const real* block, GLOBAL const int* ids, int slot, Nearest* best) {
  realw gx = splat_w(ray->o.x) - load_w(block);
  realw gy = splat_w(ray->o.y) - load_w(block + LANES);
  realw gz = splat_w(ray->o.z) - load_w(block + 2 * LANES);
  realw ux = load_w(block + 3 * LANES), uy = load_w(block + 4 * LANES), uz = load_w(block + 5 * LANES);
  realw length = load_w(block + 6 * LANES), r = load_w(block + 7 * LANES);
  realw dx = splat_w(ray->d.x), dy = splat_w(ray->d.y), dz = splat_w(ray->d.z), zero = splat_w(R(0.0));
  realw o_along = gx * ux + gy * uy + gz * uz, d_along = dx * ux + dy * uy + dz * uz;
  realw a = dx * dx + dy * dy + dz * dz - d_along * d_along;
  realw b = splat_w(R(2.0)) * (gx * dx + gy * dy + gz * dz - o_along * d_along);
  realw c = gx * gx + gy * gy + gz * gz - o_along * o_along - r * r;
  realw discriminant = b * b - splat_w(R(4.0)) * a * c;
  maskw hit = le_w(zero, discriminant);
  if (!any_w(hit)) return;
  realw root = sqrt_w(discriminant), scale = splat_w(R(0.5)) / a;
  realw near = (-b - root) * scale, far = (root - b) * scale;
  realw near_along = o_along + near * d_along;
  maskw near_hit = le_w(splat_w(ray->t_min), near) & le_w(zero, near_along) & le_w(near_along, length);
  realw t = sel_w(near_hit, near, far);
  realw along = o_along + t * d_along;
  hit = hit & le_w(zero, along) & le_w(along, length);
  take_nearest_w(hit & in_range_w(t, ray, best), t, ids, -1, SHAPE_cylinder, slot, best);
}
