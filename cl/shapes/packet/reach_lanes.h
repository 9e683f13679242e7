// SPDX-License-Identifier: MIT
// The cheap test in front of the robust bodies, one width; no guard. It may pass primitives that are missed, but never
// rejects one that is hit: only blocks with possible hits pay for double words. NaN passes.

/// Rays, or one in all lanes.
typedef struct {
  realw dx, dy, dz;
  realw dd_inverse, t_per_length;  ///< As in rays/ray.h.
  realw t_min, t_max;              ///< The range of t.
} Reaching_w;

/// Lanes whose ball of radius `reach` about the point o - f may be hit within [t_min, t_max].
/// The computed distance of line and centre is off by at most 10 u |f| (f rounded, its place along the ray, products
/// and quotient), the squares by 3 u; 32 u of |fx| + |fy| + |fz| covers both, and 2^-120 what underflow does to them.
/// |d| >= 1, so the ray is within the ball for |t - k| <= half the chord at most.
FN maskw reaches_ball_w(const Reaching_w* ray, realw fx, realw fy, realw fz, realw reach) {
  realw dx = ray->dx, dy = ray->dy, dz = ray->dz, tiny = splat_w(R(0x1p-120));
  realw k = -fma_w(fz, dz, fma_w(fy, dy, fx * dx)) * ray->dd_inverse;
  realw lx = fma_w(k, dx, fx), ly = fma_w(k, dy, fy), lz = fma_w(k, dz, fz);
  realw off = fma_w(splat_w(R(0x1p-19)), abs_w(fx) + abs_w(fy) + abs_w(fz), tiny), limit = reach + off;
  realw spare = fma_w(limit, limit, tiny) - fma_w(lz, lz, fma_w(ly, ly, lx * lx));
  // Half the chord, and what k and t_min may be off by.
  realw half_chord = fma_w(sqrt_w(spare), ray->t_per_length, off);
  return ~(lt_w(spare, splat_w(R(0.0))) | lt_w(ray->t_max, k - half_chord) | lt_w(k + half_chord, ray->t_min));
}

/// One ray and a ball a lane, within [t_min, best so far].
FN maskw within_reach_w(const Ray* ray, const Nearest* best, realw fx, realw fy, realw fz, realw reach) {
  Reaching_w one;
  one.dx = splat_w(ray->d.x);
  one.dy = splat_w(ray->d.y);
  one.dz = splat_w(ray->d.z);
  one.dd_inverse = splat_w(ray->dd_inverse);
  one.t_per_length = splat_w(ray->t_per_length);
  one.t_min = splat_w(ray->t_min);
  one.t_max = splat_w(best->t);
  return reaches_ball_w(&one, fx, fy, fz, reach);
}
