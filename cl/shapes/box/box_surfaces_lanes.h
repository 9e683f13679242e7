// SPDX-License-Identifier: MIT
// Surfaces of LANES boxes, one a lane: box_surface of box.h in lanes, operation by operation. One width; no guard.

/// One axis of the boxes, and of the rays that have hit them.
typedef struct {
  realw lo, hi, o, d;
  maskw is_back;  ///< Lanes that meet hi first.
} BoxAxis_w;

/// The plane of the axis that each ray meets first (or last), and its number.
FN realw box_plane_w(const BoxAxis_w* axis, int number, int is_first, PRIVATE intw* face) {
  maskw is_hi = is_first ? axis->is_back : ~axis->is_back;
  *face = sel_int_w(is_hi, splat_int_w(2 * number + 1), splat_int_w(2 * number));
  return sel_w(is_hi, axis->hi, axis->lo);
}

/// box_face of box.h.
FN intw box_faces_w(PRIVATE const BoxAxis_w* axes, realw t) {
  realw zero = splat_w(R(0.0)), gap = splat_w(REAL_MAX);
  intw best, face;
  (void)box_plane_w(&axes[0], 0, 1, &best);
#if TIER_FAST
  best = splat_int_w(0);
  for (int i = 0; i < 6; ++i) {
    PRIVATE const BoxAxis_w* axis = axes + i / 2;
    realw other = abs_w(((i & 1) != 0 ? axis->hi : axis->lo) - axis->o - t * axis->d);
    maskw is_nearer = (lt_w(axis->d, zero) | lt_w(zero, axis->d)) & ~le_w(gap, other);
    gap = sel_w(is_nearer, other, gap);
    best = sel_int_w(is_nearer, splat_int_w(i), best);
  }
  (void)face;
#else
  maskw is_found = none_w();
  for (int i = 0; i < 6; ++i) {
    PRIVATE const BoxAxis_w* axis = axes + i % 3;
    realw other = (box_plane_w(axis, i % 3, i < 3, &face) - axis->o) / axis->d;
    maskw is_taken;
    if (HAS_INSTANCES || TIER_ROBUST) {
      other = abs_w(other - t);
      is_taken = lt_w(other, gap);
      gap = sel_w(is_taken, other, gap);
    } else {
      is_taken = eq_w(other, t) & ~is_found;
      is_found = is_found | is_taken;
    }
    best = sel_int_w(is_taken, face, best);
  }
  (void)zero;
#endif
  return best;
}

/// between_faces of hits/departure.h.
FN realw between_faces_w(realw x, realw lo, realw hi) {
  realw u2 = splat_w(R(2.0) * real_roundoff()), size = hi - lo;
  realw first = lo + u2 * (abs_w(lo) + size), last = hi - u2 * (abs_w(hi) + size);
  realw inside = sel_w(lt_w(x, first), first, sel_w(lt_w(last, x), last, x));
  return sel_w(lt_w(first, last), inside, x);
}

/// As flat_surfaces.
FN maskw box_surfaces_w(const Scene* scene, const SurfaceHits_w* hits, maskw which, GLOBAL const real* boxes, intw at,
                        Surfaces_w* s, HitParameters_w* parameters) {
  (void)parameters;  // u = v = 0.
  realw zero = splat_w(R(0.0)), one = splat_w(R(1.0)), facing = zero, bound = zero;
  real3w hit = fma3_w(hits->t, hits->d, hits->o);
  realw o[3] = {hits->o.x, hits->o.y, hits->o.z}, d[3] = {hits->d.x, hits->d.y, hits->d.z};
  realw p[3] = {hit.x, hit.y, hit.z}, n[3], inside[3];
  BoxAxis_w axes[3];
  for (int i = 0; i < 3; ++i) {
    axes[i].lo = gather_w(boxes + 2 * i * SCENE_LANES, at);
    axes[i].hi = gather_w(boxes + (2 * i + 1) * SCENE_LANES, at);
    axes[i].o = o[i];
    axes[i].d = d[i];
    axes[i].is_back = lt_w(one / d[i], zero);
  }
  intw face = box_faces_w(axes, hits->t);
  for (int i = 0; i < 3; ++i) {
    maskw is_lo = ~nonzero_w(face - splat_int_w(2 * i)), is_hi = ~nonzero_w(face - splat_int_w(2 * i + 1));
    n[i] = sel_w(is_hi, one, sel_w(is_lo, -one, zero));
    p[i] = sel_w(is_hi, axes[i].hi, sel_w(is_lo, axes[i].lo, p[i]));
    facing = sel_w(is_lo | is_hi, n[i] * d[i], facing);
    inside[i] = sel_w(is_lo | is_hi, p[i], between_faces_w(p[i], axes[i].lo, axes[i].hi));
  }
  real3w position = vec3_w(p[0], p[1], p[2]), point = vec3_w(inside[0], inside[1], inside[2]);
  if (HAS_INSTANCES & !TIER_FAST) position = sel3_w(hits->is_placed, point, position);
  real3w normal = vec3_w(n[0], n[1], n[2]);
  maskw plain = take_own_surfaces_w(scene, hits, which, position, normal, facing, bound, s);
  if (TIER_FAST) return plain;
  s->point = sel3_w(plain & ~hits->is_placed, point, s->point);
  if (HAS_INSTANCES) {
    bound = departure_bound_w(scene, hits, max3_w(abs3_w(s->position)));
    s->bound = sel_w(plain & hits->is_placed, bound, s->bound);
  }
  return plain;
}
