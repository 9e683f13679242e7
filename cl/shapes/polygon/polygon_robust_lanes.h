// SPDX-License-Identifier: MIT
// Flat polygons in the robust tier, one width; no guard. edge_lanes.h finds the few lanes that are hit, and put_off.h
// computes t of each.

/// Three corners of a polygon, sheared, and all of it along the ray's largest axis.
typedef struct {
  ShearedVertex_w at_a, at_b, at_c;
  realw of_a, of_b, of_c;  ///< The unnormalised weights of the corners at the ray.
  realw z_min, z_max;
} Polygon_w;

/// The lateral distance of a sheared vertex from the ray.
FN realw aside_of_w(ShearedVertex_w v) { return abs_w(v.x) + abs_w(v.y); }

/// t of each lane: approximately, and its certain bounds.
typedef struct {
  real approximate[LANES], least[LANES], most[LANES];
} ApproximateT_w;

/// Lanes whose t may lie within [t_min, best so far]. The approximate t is the weighted mean of z. Its bounds add 2^-20
/// of it and the change of the weights for vertices that are off by some u of their distance. t is always within the
/// polygon's range along the ray's largest axis (polygon_exact_t). Where the ray grazes the polygon, or the polygon is
/// nearly a line, only that range is certain.
FN maskw in_range_approximately_w(const Ray* ray, const Nearest* best, const Polygon_w* p, PRIVATE ApproximateT_w* t) {
  realw shear = splat_w(ray->shear_z), sum = p->of_a + p->of_b + p->of_c, scale = shear / sum, area = abs_w(sum);
  realw approximate = fma_w(p->of_c, p->at_c.z, fma_w(p->of_b, p->at_b.z, p->of_a * p->at_a.z)) * scale;
  realw z = max_w(abs_w(p->z_min), abs_w(p->z_max));
  realw l = max_w(aside_of_w(p->at_c), max_w(aside_of_w(p->at_b), aside_of_w(p->at_a)));
  realw turned = l * (p->z_max - p->z_min) * abs_w(scale);
  realw spare = fma_w(splat_w(R(0x1p-17)) * (l + z), turned, splat_w(R(0x1p-20)) * z);
  realw one = p->z_min * shear, other = p->z_max * shear, slip = splat_w(R(0x1p-22)) * z * abs_w(shear);
  realw first = min_w(one, other) - slip, last = max_w(one, other) + slip;
  // A polygon whose area is only rounding error, or nearly leaves the range of numbers, may have no t.
  maskw is_clear = lt_w(turned, splat_w(R(256.0))) & lt_w(splat_w(R(0x1p-18)) * l * l, area) &
                   lt_w(splat_w(R(0x1p-100)), area) & lt_w(area * (l + z), splat_w(R(0x1p+120)));
  realw least = sel_w(is_clear, max_w(approximate - spare, first), first);
  realw most = sel_w(is_clear, min_w(approximate + spare, last), splat_w(REAL_MAX));
  store_w(approximate, t->approximate);
  store_w(least, t->least);
  store_w(most, t->most);
  return ~(lt_w(splat_w(best->t), least) | lt_w(most, splat_w(ray->t_min)));
}

/// Takes the lanes that are hit, one by one. block: the polygons' own, of so many corners.
FN void take_polygons_w(const Ray* ray, Nearest* best, maskw hit, const ApproximateT_w* t, GLOBAL const real* block,
                        GLOBAL const int* ids, int corners, int kind, int slot) {
  uint candidates = bits_w(hit);
  while (candidates != 0u) {
    int lane = first_bit(candidates);
    candidates &= candidates - 1u;
    HitAbout at;
    at.approximate = t->approximate[lane];
    at.least = t->least[lane];
    at.most = t->most[lane];
    at.prim = block + lane;
    at.points = corners;
    nearest_put_off(ray, best, &at, LANES, ids[lane], kind, slot + lane);
  }
}
