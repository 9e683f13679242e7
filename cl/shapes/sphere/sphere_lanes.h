// SPDX-License-Identifier: MIT
// Ray against LANES spheres, stable form: discriminant from the distance of line and centre, roots without
// cancellation. E. Haines, J. Guenther, T. Akenine-Moeller, "Precision Improvements for Ray/Sphere Intersection",
// Ray Tracing Gems, ch. 7, 2019. Weak (sound in the robust tier): r / distance below 10^-6, eye close to a huge sphere.
// The sphere just left is met again only at its other root, -2 (f.d) / (d.d): the known root is exactly 0.

enum { PACKET_BODY_sphere_w = PACKET_BODY_SPHERE };
#define sphere_SURFACES sphere_surfaces_w

/// prim: its reals, LANES apart.
FN Ball sphere_ball_w(GLOBAL const real* prim) {
  return ball_of(vec3(prim[0], prim[LANES], prim[2 * LANES]), prim[3 * LANES]);
}

#if TIER_ROBUST
#include "shapes/sphere/sphere_robust_lanes.h"
#elif TIER_FAST
#include "shapes/sphere/sphere_fast_lanes.h"
#else
FN void sphere_block_w(const Ray* ray, GLOBAL const real* block, GLOBAL const int* ids, int slot, Nearest* best) {
  realw fx = splat_w(ray->o.x) - load_w(block);
  realw fy = splat_w(ray->o.y) - load_w(block + LANES);
  realw fz = splat_w(ray->o.z) - load_w(block + 2 * LANES);
  realw r = load_w(block + 3 * LANES);
  realw dx = splat_w(ray->d.x), dy = splat_w(ray->d.y), dz = splat_w(ray->d.z);
  real a_scalar = dot3(ray->d, ray->d);
  realw a = splat_w(a_scalar);

  realw b = fma_w(fz, dz, fma_w(fy, dy, fx * dx));
  realw k = b / a;
  realw lx = fma_w(-k, dx, fx), ly = fma_w(-k, dy, fy), lz = fma_w(-k, dz, fz);
  realw r2 = r * r;
  realw d = r2 - fma_w(lz, lz, fma_w(ly, ly, lx * lx));
  maskw hit = le_w(splat_w(R(0.0)), d);
  maskw departed = hit & ~hit;
  if (ray->departed >= 0) departed = is_departed_w(ids, ray);
  if (!any_w(hit | departed)) return;

  // A compare, not the sign bit: some devices lose the sign of a zero b.
  realw root = sqrt_w(a * max_w(d, splat_w(R(0.0))));
  realw q = -b - sel_w(lt_w(b, splat_w(R(0.0))), -root, root);
  realw c = fma_w(fz, fz, fma_w(fy, fy, fx * fx)) - r2;
  realw t0 = q / a, t1 = c / q;
  realw near = sel_w(lt_w(t1, t0), t1, t0), far = sel_w(lt_w(t1, t0), t0, t1);
  realw t = sel_w(le_w(splat_w(ray->t_min), near), near, far);

  realw other = splat_w(-R(2.0)) * k;
  t = sel_w(departed, other, t);
  hit = (hit & ~departed) | (departed & lt_w(splat_w(R(0.0)), other));
#if REAL_BITS == 64
  // t is clamped to the slabs that the tree uses. After a departure a root outside of them is no hit: the origin may be
  // off the sphere.
  realw cx = load_w(block), cy = load_w(block + LANES), cz = load_w(block + 2 * LANES);
  realw within = within_slabs_w(ray, t, cx - r, cx + r, cy - r, cy + r, cz - r, cz + r);
  hit = hit & (~departed | eq_w(within, t));
  t = within;
#endif
  if (ray->is_outward) hit = hit & ~departed;
  take_nearest_w(hit & in_range_w(t, ray, best), t, ids, -1, SHAPE_sphere, slot, best);
}
#endif
