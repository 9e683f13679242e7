// SPDX-License-Identifier: MIT
// Which rays of a packet certainly hit or certainly miss a flat polygon, robust tier. Plain arithmetic in the polygon's
// own coordinates decides nearly all rays, at lower cost than the exact test (docs/decisions/0016-polygon-frames.md).
// The exact test decides the others, so the hits have its bits. For packets of arbitrary rays, whose lists are short.
// One width; no guard.
//
// A point g of the plane is a + u e + v f, from corner a along the edges e to the next and f to the last corner; with
// n = e x f, u = (f x n).(g - a) / n.n and v = (n x e).(g - a) / n.n: three dot products, whose constants are folded
// in. Norms are sums of absolute values, A = |e| |f|, E = |e| + |f|, d is 1 ... 2 along its largest axis, r >= |o - a|
// + E, w the roundoff. Where A^2 <= 64 n.n, n is off by 4 w A at most, so
//   where a ray hits (|t| <= r), t = n.(a - o) / n.d is off by w 56 r A / |n.d|, which `spare` holds four times over;
//   the place on the ray by twice that and 6 w r, f x n and n x e over n.n by 2^7 w of their length: u + v by less than
//   2^10 w r A / |n.d| times the sum of those lengths, of which `margin` is twice. The exact test's own rounding of
//   corners, 4 w r across the ray, and a fourth corner that is not quite b + f, by 2^-18 E at most, are within it.
// n.d is the computed value, so the bounds hold for nearly parallel rays as well: for them nothing is certain.

/// LANES polygons, a plane of LANES reals each.
typedef struct {
  real3w n, to_u, to_v;
  realw of_t, of_u, of_v;  ///< The dot products' constants, for rays whose origin is `o`.
  realw spare, margin;     ///< A and A (|to_u| + |to_v|), times their constants.
  real3w o;                ///< Of each ray, from the first polygon's corner.
  realw reach;             ///< Of each ray: at least its r of any polygon.
  uint plain;              ///< Bit i: polygon i is such that the bounds hold.
} PolygonCoordinates_w;

FN PolygonCoordinates_w polygon_coordinates_w(const Packet_w* p, GLOBAL const real* block, uint there, int corners) {
  PolygonCoordinates_w frames;
  real3w a = corners_of_block_w(block, 0), b = corners_of_block_w(block, 1);
  real3w last = corners_of_block_w(block, corners - 1), e = sub3_w(b, a), f = sub3_w(last, a);
  real3w n = cross3_w(e, f);
  realw size_e = size1_w(e), size_f = size1_w(f), area = size_e * size_f, nn = dot3_w(n, n);
  realw inverse = splat_w(R(1.0)) / nn;
  frames.n = n;
  frames.to_u = scale3_w(inverse, cross3_w(f, n));
  frames.to_v = scale3_w(inverse, cross3_w(n, e));
  real3w first = vec3_w(splat_w(block[0]), splat_w(block[LANES]), splat_w(block[2 * LANES]));
  real3w from_first = sub3_w(a, first);
  // Across the polygon the middle is 0, its edges +-1/2; of a triangle, 1/2 is on the edge and less within.
  realw one_half = splat_w(R(0.5));
  if (corners == 3) {
    frames.to_u = negate3_w(frames.to_u);
    frames.to_v = negate3_w(frames.to_v);
  }
  realw u_first = dot3_w(frames.to_u, from_first), v_first = dot3_w(frames.to_v, from_first);
  frames.of_t = -dot3_w(n, from_first);
  frames.of_u = corners == 3 ? one_half - u_first : -one_half - u_first;
  frames.of_v = corners == 3 ? one_half - v_first : -one_half - v_first;
  frames.spare = splat_w(R(0x1p-16)) * area;
  frames.margin = splat_w(R(0x1p-13)) * area * (size1_w(frames.to_u) + size1_w(frames.to_v));
  maskw plain =
      le_w(splat_w(R(0x1p-40)), area) & le_w(area, splat_w(R(0x1p+40))) & le_w(area * area, splat_w(R(64.0)) * nn);
  if (corners == 4) {
    real3w aslant = sub3_w(sub3_w(corners_of_block_w(block, 2), b), f);
    plain = plain & le_w(size1_w(aslant), splat_w(R(0x1p-18)) * (size_e + size_f));
  }
  realw radius = size1_w(from_first) + (size_e + size_f);
  radius = splat_w(largest_w(sel_w(plain, radius, splat_w(R(0.0)))));
  frames.o = sub3_w(p->o, first);
  frames.reach = size1_w(frames.o) + radius;
  // Next to a far larger polygon the bounds of a small one are too wide to be useful.
  frames.plain = there & bits_w(plain & le_w(radius, splat_w(R(512.0)) * (size_e + size_f)));
  return frames;
}

FN realw splat_of_w(PRIVATE const realw* plane, int i) { return splat_w(get_w(plane, i)); }

/// n.v + c of polygon i's n and c.
FN realw row_with_w(PRIVATE const real3w* n, PRIVATE const realw* c, int i, real3w v) {
  realw x = fma_w(splat_of_w(&n->x, i), v.x, splat_of_w(c, i));
  return fma_w(splat_of_w(&n->z, i), v.z, fma_w(splat_of_w(&n->y, i), v.y, x));
}

/// Puts off the hits that are certain and certainly the nearest, for the rays of `active`. Returns the polygons that
/// are undecided for some rays; open[i] has the undecided rays of polygon i. No branch depends on what is hit: the
/// processor would mispredict it.
FN uint meet_coordinates_w(const Scene* scene, Packet_w* p, GLOBAL const real* block, GLOBAL const int* ids, uint there,
                           int slot, int kind, maskw active, int corners, PRIVATE maskw* open) {
  PolygonCoordinates_w frames = polygon_coordinates_w(p, block, there, corners);
  realw best = p->bound, best_least = splat_w(REAL_MAX), bound = p->bound, middle = splat_w(R(0.5));
  intw best_at = splat_int_w(-1);
  uint still = 0u;
  for (uint prims = there; prims != 0u; prims &= prims - 1u) {
    int i = first_bit(prims);
    if ((frames.plain >> i & 1u) == 0u) {
      open[i] = active;
      still |= 1u << i;
      continue;
    }
    real3w n = vec3_w(splat_of_w(&frames.n.x, i), splat_of_w(&frames.n.y, i), splat_of_w(&frames.n.z, i));
    realw inverse = splat_w(-R(1.0)) / dot3_w(n, p->d), t = row_with_w(&frames.n, &frames.of_t, i, frames.o) * inverse;
    real3w at = fma3_w(t, p->d, frames.o);
    realw u = row_with_w(&frames.to_u, &frames.of_u, i, at), v = row_with_w(&frames.to_v, &frames.of_v, i, at);
    realw off = corners == 4 ? max_w(abs_w(u), abs_w(v)) : max_w(max_w(u, v), (middle - u) - v);
    realw turned = frames.reach * abs_w(inverse);
    realw margin = splat_of_w(&frames.margin, i), spare = splat_of_w(&frames.spare, i);
    realw least = fma_w(-spare, turned, t), most = fma_w(spare, turned, t);
    // Comparisons with a NaN are false, so nothing is certain then.
    maskw may_hit = active & ~lt_w(fma_w(margin, turned, middle), off) & ~lt_w(bound, least) & ~lt_w(most, p->t_min);
    if (p->has_ends) may_hit = may_hit & ~packet_end_w(p, ids[i]);
    maskw nearest =
        may_hit & lt_w(off, fma_w(-margin, turned, middle)) & le_w(p->t_min, least) & lt_w(most, best_least);
    best = sel_w(nearest, t, best);
    best_least = sel_w(nearest, least, best_least);
    best_at = sel_int_w(nearest, splat_int_w(i), best_at);
    bound = sel_w(nearest, most, bound);
    open[i] = may_hit & ~nearest;
    still |= (uint)any_w(open[i]) << i;
  }
  maskw hit = ~lt_int_w(best_at, splat_int_w(0));
  if (any_w(hit)) {
    intw at = sel_int_w(hit, best_at, splat_int_w(0));
    packet_put_off_w(scene, p, hit, hit, best, best_least, bound, gather_int_w(ids, at), kind, at + splat_int_w(slot));
  }
  return still;
}
