// SPDX-License-Identifier: MIT
// Ray against LANES spheres, robust tier: lanes find the few that may be met, sphere_exact.h decides each of them.
// The sphere just left is met again only at its other root: the known root is exactly 0.

FN void LANED(sphere_block)(const Ray* ray, GLOBAL const real* block, GLOBAL const int* ids, int slot, Nearest* best) {
  realw fx = splat_w(ray->o.x) - load_w(block), fy = splat_w(ray->o.y) - load_w(block + LANES);
  realw fz = splat_w(ray->o.z) - load_w(block + 2 * LANES);
  uint candidates = bits_w(LANED(within_reach)(ray, best, fx, fy, fz, load_w(block + 3 * LANES)));
  if (ray->left >= 0) candidates |= bits_w(LANED(is_left)(ids, ray));
  while (candidates != 0u) {
    int lane = first_bit(candidates);
    candidates &= candidates - 1u;
    GLOBAL const real* prim = block + lane;
    Exact3 f = exact_difference(ray->o, vec3(prim[0], prim[LANES], prim[2 * LANES]));
    real t, r = prim[3 * LANES];
    int is_left = ray->left >= 0 && ids[lane] == ray->left, hit = 1;
    if (is_left || !sphere_is_plain(ray, f, r, &t)) {
      SphereRoots roots = sphere_roots(ray, f, r);
      t = ray->t_min <= roots.near ? roots.near : roots.far;
      hit = roots.is_met;
      if (is_left) hit = !ray->is_outward && sphere_is_left_at(ray, prim, LANES, roots.other);
      if (is_left) t = roots.other;
    }
    if (hit && ray->t_min <= t) nearest_take(best, t, ids[lane], SHAPE_sphere, slot + lane);
  }
}
