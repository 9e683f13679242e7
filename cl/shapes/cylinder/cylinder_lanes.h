// SPDX-License-Identifier: MIT
// Ray against LANES open cylinders: the sphere's stable form (sphere_lanes.h) for f x v and d x v, v the axis, whose
// products keep the sign of what is parallel to it; then each root's place along the axis. v is a unit vector that was
// rounded; the rounded one is taken as exact, so the mantle is |f x v| = r |v|. A ray parallel to the axis misses. The
// cylinder just left: the other root, -2 (f.d) / (d.d).

enum { PACKET_BODY_cylinder_w = PACKET_BODY_CYLINDER };
#define cylinder_SURFACES cylinder_surfaces_w

/// prim: its reals, LANES apart.
FN Ball cylinder_ball_w(GLOBAL const real* prim) {
  // Around the middle of the axis, up to what rounding does to it; the radius reaches beyond the rims.
  real reach = R(0.5) * prim[6 * LANES];
  real3 foot = vec3(prim[0], prim[LANES], prim[2 * LANES]);
  real3 v = vec3(prim[3 * LANES], prim[4 * LANES], prim[5 * LANES]);
  real most = max3(abs3(foot)) + reach;
  return ball_of(fma3(reach, v, foot), prim[7 * LANES] + reach + R(0x1p-20) * most);
}

#if TIER_COMPENSATED
#include "shapes/cylinder/cylinder_slabs_lanes.h"
#endif
#if TIER_ROBUST
#include "shapes/cylinder/cylinder_hit_lanes.h"
#include "shapes/cylinder/cylinder_robust_lanes.h"
#elif TIER_FAST
#include "shapes/cylinder/cylinder_fast_lanes.h"
#else
FN void cylinder_block_w(const Ray* ray, GLOBAL const real* block, GLOBAL const int* ids, int slot, Nearest* best) {
  realw gx = splat_w(ray->o.x) - load_w(block);
  realw gy = splat_w(ray->o.y) - load_w(block + LANES);
  realw gz = splat_w(ray->o.z) - load_w(block + 2 * LANES);
  realw ux = load_w(block + 3 * LANES), uy = load_w(block + 4 * LANES), uz = load_w(block + 5 * LANES);
  realw length = load_w(block + 6 * LANES), r = load_w(block + 7 * LANES);
  realw rx = splat_w(ray->d.x), ry = splat_w(ray->d.y), rz = splat_w(ray->d.z);
  realw uu = fma_w(uz, uz, fma_w(uy, uy, ux * ux));
  realw fx = difference_of_products_w(gy, uz, gz, uy), dx = difference_of_products_w(ry, uz, rz, uy);
  realw fy = difference_of_products_w(gz, ux, gx, uz), dy = difference_of_products_w(rz, ux, rx, uz);
  realw fz = difference_of_products_w(gx, uy, gy, ux), dz = difference_of_products_w(rx, uy, ry, ux);

  realw a = fma_w(dz, dz, fma_w(dy, dy, dx * dx));
  realw b = fma_w(fz, dz, fma_w(fy, dy, fx * dx));
  realw k = b / a;
  realw lx = fma_w(-k, dx, fx), ly = fma_w(-k, dy, fy), lz = fma_w(-k, dz, fz);
  realw r2 = r * r * uu;
  realw d = r2 - fma_w(lz, lz, fma_w(ly, ly, lx * lx));
  realw zero = splat_w(R(0.0));
  maskw hit = le_w(zero, d);
  maskw departed = hit & ~hit;
  if (ray->departed >= 0) departed = is_departed_w(ids, ray);
  if (!any_w(hit | departed)) return;

  realw o_along = fma_w(gz, uz, fma_w(gy, uy, gx * ux)) / uu, d_along = fma_w(rz, uz, fma_w(ry, uy, rx * ux)) / uu;
  realw root = sqrt_w(a * max_w(d, zero));
  realw q = -b - sel_w(lt_w(b, zero), -root, root);
  realw c = fma_w(fz, fz, fma_w(fy, fy, fx * fx)) - r2;
  realw t0 = q / a, t1 = c / q;
  realw near = sel_w(lt_w(t1, t0), t1, t0), far = sel_w(lt_w(t1, t0), t0, t1);
  realw near_along = fma_w(near, d_along, o_along);
  maskw near_hit = le_w(splat_w(ray->t_min), near) & le_w(zero, near_along) & le_w(near_along, length);
  realw t = sel_w(near_hit, near, far);

  realw other = splat_w(-R(2.0)) * k;
  t = sel_w(departed, other, t);
  realw along = fma_w(t, d_along, o_along);
  hit = ((hit & ~departed) | (departed & lt_w(zero, other))) & le_w(zero, along) & le_w(along, length);
#if REAL_BITS == 64
  if (ray->departed >= 0) hit = hit & (~departed | within_cylinder_slabs_w(ray, block, t));
#endif
  if (ray->is_outward) hit = hit & ~departed;
  take_nearest_w(hit & in_range_w(t, ray, best), t, ids, -1, SHAPE_cylinder, slot, best);
}
#endif
