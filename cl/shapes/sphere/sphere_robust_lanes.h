// SPDX-License-Identifier: MIT
// Ray against LANES spheres, robust tier: lanes find the few that may be hit. Spheres that the line certainly passes
// through are taken with a t of a few digits (put_off.h); sphere_exact.h decides each of the others. The sphere just
// left is met again only at its other root: the known root is exactly 0.

/// Of LANES spheres: the line's point nearest to the centre, how far that may be off, and r^2 less the square of its
/// distance from the centre.
typedef struct {
  realw k, off, inside;
  maskw sure;    ///< Lanes whose sphere the line passes through.
  maskw behind;  ///< Lanes whose centre the ray goes away from.
} SphereChord_w;

/// Lanes whose sphere may be met within [t_min, best so far]. NaN passes. The computed distance of line and centre is
/// off by at most 10 u |f| (f = o - c rounded, its place along the ray, products and quotient), the squares by 3 u;
/// 32 u of |fx| + |fy| + |fz| covers both, and 2^-120 what underflow does to them. Where the origin is outside of the
/// sphere and the line's nearest point is behind the origin, the whole sphere is behind it.
FN maskw sphere_in_reach_w(const Ray* ray, const Nearest* best, GLOBAL const real* block,
                           PRIVATE SphereChord_w* chord) {
  realw dx = splat_w(ray->d.x), dy = splat_w(ray->d.y), dz = splat_w(ray->d.z), tiny = splat_w(R(0x1p-120));
  realw fx = splat_w(ray->o.x) - load_w(block), fy = splat_w(ray->o.y) - load_w(block + LANES);
  realw fz = splat_w(ray->o.z) - load_w(block + 2 * LANES), r = load_w(block + 3 * LANES);
  realw b = fma_w(fz, dz, fma_w(fy, dy, fx * dx)), k = -b * splat_w(ray->dd_inverse);
  realw lx = fma_w(k, dx, fx), ly = fma_w(k, dy, fy), lz = fma_w(k, dz, fz);
  realw size = abs_w(fx) + abs_w(fy) + abs_w(fz), off = fma_w(splat_w(R(0x1p-19)), size, tiny), limit = r + off;
  realw apart = fma_w(lz, lz, fma_w(ly, ly, lx * lx));
  maskw passes_by = lt_w(fma_w(limit, limit, tiny), apart);
  realw reach = fma_w(r, splat_w(ray->t_per_length), off), ff = fma_w(fz, fz, fma_w(fy, fy, fx * fx));
  maskw beyond = lt_w(splat_w(best->t), k - reach) | lt_w(k + reach, splat_w(ray->t_min));
  chord->behind = lt_w(off, b);
  if (R(0.0) <= ray->t_min)
    beyond = beyond | (chord->behind & lt_w(fma_w(r, r, tiny), ff * splat_w(R(1.0) - R(0x1p-19))));
  chord->k = k;
  chord->off = off;
  chord->inside = fma_w(r, r, -apart);
  // The squares' difference is off by less than 16 u |f| r and 4 u r^2.
  chord->sure = le_w(splat_w(R(0x1p-14)) * r * (size + r), chord->inside);
  return ~(passes_by | beyond);
}

FN void sphere_block_w(const Ray* ray, GLOBAL const real* block, GLOBAL const int* ids, int slot, Nearest* best) {
  SphereChord_w chord;
  uint candidates = bits_w(sphere_in_reach_w(ray, best, block, &chord)), departed = 0u;
  if (ray->departed >= 0) {
    maskw is_departed = is_departed_w(ids, ray);
    candidates &= ~bits_w(is_departed);
    if (!ray->is_outward) departed = bits_w(is_departed & ~chord.behind);
    candidates |= departed;
  }
  // Padding is a point at the origin, where every camera ray begins.
  if (candidates != 0u) candidates &= bits_w(is_there_w(ids));
  if (candidates == 0u) return;
  real k[LANES], off[LANES], inside[LANES];
  store_w(chord.k, k);
  store_w(chord.off, off);
  store_w(chord.inside, inside);
  for (uint sure = bits_w(chord.sure) & ~departed; candidates != 0u; candidates &= candidates - 1u) {
    int lane = first_bit(candidates), id = ids[lane];
    GLOBAL const real* prim = block + lane;
    if (SPHERES_WAIT) {
      HitAbout at;
      at.prim = prim;
      at.points = 1;
      if ((sure >> lane & 1u) != 0u && sphere_about(ray, k[lane], off[lane], inside[lane], &at)) {
        nearest_put_off(ray, best, &at, LANES, id, SHAPE_sphere, slot + lane);
        continue;
      }
      nearest_settle(ray, best, LANES);
    }
    sphere_decide(ray, prim, LANES, id, SHAPE_sphere, slot + lane, best);
  }
}
