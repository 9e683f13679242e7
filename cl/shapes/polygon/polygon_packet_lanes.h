// SPDX-License-Identifier: MIT
// LANES rays against one flat polygon at a time of a block, of 3 or 4 corners, with the same bits as one by one. One
// width; no guard.

/// Corner k of LANES polygons.
FN real3w corners_of_block_w(GLOBAL const real* block, int k) { return load_planes3_w(block + 3 * k * LANES); }

/// Polygons of a block that some ray may meet.
FN uint may_meet_polygons_w(const Packet_w* p, GLOBAL const real* block, GLOBAL const int* ids, int corners) {
  uint there = bits_w(nonzero_w(load_int_w(ids) - splat_int_w(-1)));
  if (!is_alike_w(p)) return there;
  real3w lo = corners_of_block_w(block, 0), hi = lo, near, far;
  for (int k = 1; k < corners; ++k) {
    real3w v = corners_of_block_w(block, k);
    lo = vec3_w(min_w(v.x, lo.x), min_w(v.y, lo.y), min_w(v.z, lo.z));
    hi = vec3_w(max_w(v.x, hi.x), max_w(v.y, hi.y), max_w(v.z, hi.z));
  }
  near.x = p->near_x == 0 ? lo.x : hi.x;
  far.x = p->near_x == 0 ? hi.x : lo.x;
  near.y = p->near_y == 2 ? lo.y : hi.y;
  far.y = p->near_y == 2 ? hi.y : lo.y;
  near.z = p->near_z == 4 ? lo.z : hi.z;
  far.z = p->near_z == 4 ? hi.z : lo.z;
  return there & may_meet_w(p, near, far);
}

#if TIER_FAST
FN void polygon_packet_w(const Scene* scene, Packet_w* p, GLOBAL const real* block, GLOBAL const int* ids, int slot,
                         int kind, maskw active, int corners) {
  (void)scene;
  for (uint prims = may_meet_polygons_w(p, block, ids, corners); prims != 0u; prims &= prims - 1u) {
    int i = first_bit(prims);
    GLOBAL const real *a = block + i, *b = a + 3 * LANES, *c = a + 3 * (corners - 1) * LANES;
    realw ax = splat_w(a[0]), ay = splat_w(a[LANES]), az = splat_w(a[2 * LANES]);
    realw ex = splat_w(b[0] - a[0]), ey = splat_w(b[LANES] - a[LANES]), ez = splat_w(b[2 * LANES] - a[2 * LANES]);
    realw fx = splat_w(c[0] - a[0]), fy = splat_w(c[LANES] - a[LANES]), fz = splat_w(c[2 * LANES] - a[2 * LANES]);
    realw dx = p->d.x, dy = p->d.y, dz = p->d.z;
    realw sx = p->o.x - ax, sy = p->o.y - ay, sz = p->o.z - az;
    realw px = dy * fz - dz * fy, py = dz * fx - dx * fz, pz = dx * fy - dy * fx;
    realw qx = sy * ez - sz * ey, qy = sz * ex - sx * ez, qz = sx * ey - sy * ex;
    realw inverse = splat_w(R(1.0)) / (ex * px + ey * py + ez * pz);
    realw u = inverse * (sx * px + sy * py + sz * pz), v = inverse * (dx * qx + dy * qy + dz * qz);
    realw t = inverse * (fx * qx + fy * qy + fz * qz), zero = splat_w(R(0.0)), one = splat_w(R(1.0));
    maskw hit = active & lt_w(zero, u) & lt_w(zero, v) & le_w(p->t_min, t) & le_w(t, p->t);
    hit = hit & (corners == 3 ? lt_w(u + v, one) : lt_w(u, one) & lt_w(v, one));
    if (any_w(hit)) packet_take_w(p, hit, t, splat_int_w(ids[i]), splat_int_w(kind), splat_int_w(slot + i));
  }
}
#else
#include "shapes/polygon/polygon_edges_lanes.h"
#if TIER_ROBUST
#include "shapes/polygon/polygon_coordinates_lanes.h"

/// Up to so many polygons of a block are asked exactly at once: the constants of polygon_coordinates_lanes.h take more
/// time than one exact test, and where rays are alike, than a few. With 8 lanes no alike rays pay for them but those
/// for which any hit will do.
FN int most_exact_at_once_w(const Packet_w* p) { return !is_alike_w(p) ? 1 : p->stop_at_first ? 3 : 8; }
#endif

FN void polygon_packet_w(const Scene* scene, Packet_w* p, GLOBAL const real* block, GLOBAL const int* ids, int slot,
                         int kind, maskw active, int corners) {
  (void)scene;
  uint prims = may_meet_polygons_w(p, block, ids, corners);
#if TIER_ROBUST
  maskw open[LANES];
  int has_coordinates = (int)lanes_among(prims) > most_exact_at_once_w(p);
  if (has_coordinates) prims = meet_coordinates_w(scene, p, block, ids, prims, slot, kind, active, corners, open);
#endif
  for (; prims != 0u; prims &= prims - 1u) {
    int i = first_bit(prims), id = ids[i];
    maskw asked = active;
#if TIER_ROBUST
    if (has_coordinates) asked = open[i];
#endif
    if (p->has_ends) asked = asked & ~packet_end_w(p, id);
    PolygonHits_w hits = meet_edges_w(p, block + i, asked, corners);
    if (!any_w(hits.hit)) continue;
#if TIER_ROBUST
    maskw sure = hits.hit & le_w(p->t_min, hits.least);
    packet_put_off_w(scene, p, hits.hit, sure, hits.t, hits.least, hits.most, splat_int_w(id), kind,
                     splat_int_w(slot + i));
#else
    packet_take_w(p, hits.hit, hits.t, splat_int_w(id), splat_int_w(kind), splat_int_w(slot + i));
#endif
  }
}
#endif
