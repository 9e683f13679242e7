// SPDX-License-Identifier: MIT
// LANES rays against the edges of one flat polygon, of 3 or 4 corners, exact: triangle_lanes.h and
// parallelogram_lanes.h with the roles exchanged, the same operations. One width; no guard.

/// planes: x, y, z of one vertex, LANES apart. Where all lanes have one largest axis it is chosen once.
FN ShearedVertex_w shear_for_each_w(const Packet_w* p, GLOBAL const real* planes) {
  ShearedVertex_w v;
  real3w at;
  int z = p->axis, x = z == 2 ? 0 : z + 1, y = z == 0 ? 2 : z - 1;
  if (z >= 0) {
    at = vec3_w(splat_w(planes[x * LANES]), splat_w(planes[y * LANES]), splat_w(planes[z * LANES]));
    at = sub3_w(at, p->turned_o);
  } else {
    at = vec3_w(splat_w(planes[0]), splat_w(planes[LANES]), splat_w(planes[2 * LANES]));
    at = turned3_w(p->is_x, p->is_y, sub3_w(at, p->o));
  }
  v.x = fma_w(-p->shear.x, at.z, at.x);
  v.y = fma_w(-p->shear.y, at.z, at.y);
  v.z = at.z;
  return v;
}

#if REAL_BITS == 64
/// t, clamped to the slabs of one polygon.
FN realw within_corners_each_w(const Packet_w* p, realw t, GLOBAL const real* polygon, int corners) {
  real box[6];
  for (int axis = 0; axis < 3; ++axis) {
    real lo = polygon[axis * LANES], hi = lo;
    for (int k = 1; k < corners; ++k) {
      real at = polygon[(3 * k + axis) * LANES];
      lo = at < lo ? at : lo;
      hi = hi < at ? at : hi;
    }
    box[2 * axis] = lo;
    box[2 * axis + 1] = hi;
  }
  return clamped_to_box_w(p, t, box);
}
#endif

/// Rays that hit a polygon, and where.
typedef struct {
  maskw hit;
  realw t;            ///< Roughly in the robust tier, where it certainly lies
  realw least, most;  ///< within these.
} PolygonHits_w;

/// The rays of `active` against one polygon. Corners a, b, c of a triangle; a, b, c, d of a parallelogram, whose plane
/// and t come from a, b and d: `last`.
FN PolygonHits_w meet_edges_w(const Packet_w* p, GLOBAL const real* polygon, maskw active, int corners) {
  PolygonHits_w hits;
  realw zero = splat_w(R(0.0));
  ShearedVertex_w a = shear_for_each_w(p, polygon);
  ShearedVertex_w b = shear_for_each_w(p, polygon + 3 * LANES);
  ShearedVertex_w c = shear_for_each_w(p, polygon + 6 * LANES), last = c;
  if (corners == 4) last = shear_for_each_w(p, polygon + 9 * LANES);
  realw ab = edge_function_w(a, b), bc = edge_function_w(b, c), cd = bc;
  realw la = edge_function_w(last, a), bl = bc, sum;
  maskw missed;
  if (corners == 4) {
    cd = edge_function_w(c, last);
    bl = edge_function_w(b, last);
    missed = signs_differ_w(ab, bc, cd) | signs_differ_w(bc, cd, la);
    sum = ab + la + bl;
  } else {
    missed = signs_differ_w(bc, la, ab);
    sum = bc + la + ab;
  }
  maskw hit = active & ~(missed | eq_w(sum, zero));
  hits.hit = hit;
  hits.t = hits.least = hits.most = zero;
  if (!any_w(hit)) return hits;
  realw z_min = min_w(c.z, min_w(b.z, a.z)), z_max = max_w(c.z, max_w(b.z, a.z));
  if (corners == 4) {
    z_min = min_w(last.z, z_min);
    z_max = max_w(last.z, z_max);
  }
  realw weighted = fma_w(ab, last.z, fma_w(la, b.z, bl * a.z));
#if TIER_ROBUST
  // in_range_roughly of polygon_robust_lanes.h.
  if (corners == 4) sum = bl + la + ab;
  realw scale = p->shear.z / sum, t = weighted * scale;
  realw z = max_w(abs_w(z_min), abs_w(z_max));
  realw l = max_w(aside_of_w(last), max_w(aside_of_w(b), aside_of_w(a)));
  realw turned = l * (z_max - z_min) * abs_w(scale);
  realw spare = fma_w(splat_w(R(0x1p-17)) * (l + z), turned, splat_w(R(0x1p-20)) * z);
  realw one = z_min * p->shear.z, other = z_max * p->shear.z, slip = splat_w(R(0x1p-22)) * z * abs_w(p->shear.z);
  realw first = min_w(one, other) - slip, farthest = max_w(one, other) + slip;
  realw area = abs_w(sum);
  maskw is_clear = lt_w(turned, splat_w(R(256.0))) & lt_w(splat_w(R(0x1p-18)) * l * l, area) &
                   lt_w(splat_w(R(0x1p-100)), area) & lt_w(area * (l + z), splat_w(R(0x1p+120)));
  realw least = sel_w(is_clear, max_w(t - spare, first), first);
  realw most = sel_w(is_clear, min_w(t + spare, farthest), splat_w(REAL_MAX));
  hit = hit & ~(lt_w(p->bound, least) | lt_w(most, p->t_min));
#else
  realw t = weighted / sum * p->shear.z;
#if REAL_BITS == 64
  t = within_corners_each_w(p, t, polygon, corners);
#endif
  realw one = z_min * p->shear.z, other = z_max * p->shear.z;
  realw least_t = min_w(one, other), most_t = max_w(one, other);
  t = sel_w(lt_w(t, least_t), least_t, t);
  t = sel_w(lt_w(most_t, t), most_t, t);
  hit = hit & le_w(p->t_min, t) & le_w(t, p->t);
#endif
  maskw on_edge = hit & (eq_w(ab, zero) | eq_w(bc, zero) | eq_w(cd, zero) | eq_w(la, zero));
  if (any_w(on_edge)) {
    realw rab = resolved_edge_w(ab, a, b), rbc = resolved_edge_w(bc, b, c);
    realw rcd = resolved_edge_w(cd, c, last), rla = resolved_edge_w(la, last, a);
    if (corners == 4)
      missed = signs_differ_w(rab, rbc, rcd) | signs_differ_w(rbc, rcd, rla);
    else
      missed = signs_differ_w(rbc, rla, rab);
    hit = hit & ~(on_edge & missed);
  }
  hits.hit = hit;
  hits.t = t;
#if TIER_ROBUST
  hits.least = least;
  hits.most = most;
#endif
  return hits;
}
