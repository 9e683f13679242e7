// SPDX-License-Identifier: MIT
// Ray against LANES spheres, robust tier: lanes find the few that may be met, sphere_exact.h decides each of them.
// Lanes take no root: what follows waits for their answer. The sphere just left is met again only at its other root:
// the known root is exactly 0.

/// Lanes whose sphere may be met within [t_min, best so far]; k: the line's point nearest to the centre, begins: a t
/// before all of the sphere. NaN passes. The computed distance of line and centre is off by at most 10 u |f| (f = o - c
/// rounded, its place along the ray, products and quotient), the squares by 3 u; 32 u of |fx| + |fy| + |fz| covers
/// both, and 2^-120 what underflow does to them. Where the origin is outside and the line's nearest point behind it, so
/// is all of the sphere.
FN maskw LANED(sphere_in_reach)(const Ray* ray, const Nearest* best, GLOBAL const real* block, PRIVATE realw* k,
                                PRIVATE realw* begins) {
  realw dx = splat_w(ray->d.x), dy = splat_w(ray->d.y), dz = splat_w(ray->d.z), tiny = splat_w(R(0x1p-120));
  realw fx = splat_w(ray->o.x) - load_w(block), fy = splat_w(ray->o.y) - load_w(block + LANES);
  realw fz = splat_w(ray->o.z) - load_w(block + 2 * LANES), r = load_w(block + 3 * LANES);
  realw b = fma_w(fz, dz, fma_w(fy, dy, fx * dx));
  *k = -b * splat_w(ray->dd_inverse);
  realw lx = fma_w(*k, dx, fx), ly = fma_w(*k, dy, fy), lz = fma_w(*k, dz, fz);
  realw off = fma_w(splat_w(R(0x1p-19)), abs_w(fx) + abs_w(fy) + abs_w(fz), tiny), limit = r + off;
  maskw passes_by = lt_w(fma_w(limit, limit, tiny), fma_w(lz, lz, fma_w(ly, ly, lx * lx)));
  realw reach = fma_w(r, splat_w(ray->t_per_length), off), ff = fma_w(fz, fz, fma_w(fy, fy, fx * fx));
  *begins = *k - reach;
  maskw beyond = lt_w(splat_w(best->t), *begins) | lt_w(*k + reach, splat_w(ray->t_min));
  if (R(0.0) <= ray->t_min)
    beyond = beyond | (lt_w(off, b) & lt_w(fma_w(r, r, tiny), ff * splat_w(R(1.0) - R(0x1p-19))));
  return ~(passes_by | beyond);
}

FN void LANED(sphere_block)(const Ray* ray, GLOBAL const real* block, GLOBAL const int* ids, int slot, Nearest* best) {
  realw k, begins;
  uint candidates = bits_w(LANED(sphere_in_reach)(ray, best, block, &k, &begins));
  if (ray->left >= 0) candidates |= bits_w(LANED(is_left)(ids, ray));
  // Padding is a point at the origin, where every camera ray begins.
  if (candidates != 0u) candidates &= bits_w(LANED(is_there)(ids));
  while (candidates != 0u) {
    int lane = first_bit(candidates);
    candidates &= candidates - 1u;
    sphere_candidate(ray, block + lane, LANES, ((PRIVATE const real*)&k)[lane], ids[lane], SHAPE_sphere, slot + lane,
                     best);
  }
}
