// SPDX-License-Identifier: MIT
// The cheap test in front of the robust bodies, one width; no guard. It may let through what is missed, it never drops
// what is met: only ambiguous and hit blocks pay for double words. NaN passes.

/// Lanes whose ball of radius `reach` about the point o - f may be met within [t_min, best so far].
/// The computed distance of line and centre is off by at most 9 u |f| (f rounded, its place along the ray, products and
/// quotient), the squares by 3 u; 32 u of |fx| + |fy| + |fz| covers both, and 2^-120 what underflow does to them.
/// |d| >= 1, so the ray is within the ball for |t - k| <= reach at most.
FN maskw LANED(within_reach)(const Ray* ray, const Nearest* best, realw fx, realw fy, realw fz, realw reach) {
  realw dx = splat_w(ray->d.x), dy = splat_w(ray->d.y), dz = splat_w(ray->d.z);
  realw tiny = splat_w(R(0x1p-120));
  realw k = -fma_w(fz, dz, fma_w(fy, dy, fx * dx)) / splat_w(dot3(ray->d, ray->d));
  realw lx = fma_w(k, dx, fx), ly = fma_w(k, dy, fy), lz = fma_w(k, dz, fz);
  realw limit = reach + fma_w(splat_w(R(0x1p-19)), abs_w(fx) + abs_w(fy) + abs_w(fz), tiny);
  maskw far_off = lt_w(fma_w(limit, limit, tiny), fma_w(lz, lz, fma_w(ly, ly, lx * lx)));
  return ~(far_off | lt_w(splat_w(best->t), k - limit) | lt_w(k + limit, splat_w(ray->t_min)));
}
