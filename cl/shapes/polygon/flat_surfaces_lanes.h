// SPDX-License-Identifier: MIT
// Surfaces of LANES flat polygons, one a lane: surface_at of shapes/shape.h and departure_of of hits/departure.h for
// the plain case, operation by operation. Those functions handle all other cases: near an edge, not finite. One width;
// no guard.

/// shear_point of shapes/polygon/edges.h.
FN Real2_w shear_each_w(const SurfaceHits_w* hits, real3w p) {
  Real2_w v;
  real3w q = turned3_w(hits->is_x, hits->is_y, sub3_w(p, hits->o));
  v.x = fma_w(-hits->shear_x, q.z, q.x);
  v.y = fma_w(-hits->shear_y, q.z, q.y);
  return v;
}

FN realw edge_each_w(Real2_w a, Real2_w b) { return difference_of_products_w(b.x, a.y, b.y, a.x); }

FN realw within_one_w(realw x) {
  realw zero = splat_w(R(0.0)), one = splat_w(R(1.0));
  return sel_w(lt_w(zero, x), sel_w(lt_w(x, one), x, one), zero);
}

typedef struct {
  maskw which;  ///< Lanes whose point is nearer to its plane than the one interpolated over corners.
  real3w p;
  realw off;
} NearPoint_w;

/// take_near_point of shapes/polygon/near_point.h. bound: of the point interpolated.
FN NearPoint_w near_point_w(const SurfaceHits_w* hits, real3w a, real3w e, real3w f, real3w normal, realw facing,
                            realw size, realw across, realw bound) {
  NearPoint_w near;
  real3w d = abs3_w(hits->d);
  near.p = a;
  near.off = bound;
  real3w way = sub3_w(a, hits->o);
  realw t = dot3_w(normal, way) / facing;
  near.which = lt_w(splat_w(R(32.0)) * fma_w(abs_w(t), max3_w(d), max3_w(abs3_w(hits->o))), size);
  if (!any_w(near.which)) return near;
  real3w sizes = vec3_w(abs_w(e.y * f.z) + abs_w(e.z * f.y), abs_w(e.z * f.x) + abs_w(e.x * f.z),
                        abs_w(e.x * f.y) + abs_w(e.y * f.x));
  near.p = fma3_w(t, hits->d, hits->o);
  realw rounded = fma_w(abs_w(t), dot3_w(sizes, d), dot3_w(sizes, abs3_w(way))) / across;
  near.off = splat_w(real_roundoff()) * fma_w(splat_w(R(16.0)), rounded, splat_w(R(2.0)) * max3_w(abs3_w(near.p)));
  near.which = near.which & lt_w(near.off, bound) & finite3_w(near.p);
  return near;
}

/// The cross product by plain products, as is_amid of hits/departure.h has it.
FN real3w plain_cross3_w(real3w e, real3w f) {
  return vec3_w(e.y * f.z - e.z * f.y, e.z * f.x - e.x * f.z, e.x * f.y - e.y * f.x);
}

/// The greatest component of both.
FN realw edges_size_w(real3w e, real3w f) {
  realw size_e = max3_w(abs3_w(e)), size_f = max3_w(abs3_w(f));
  return sel_w(lt_w(size_f, size_e), size_e, size_f);
}

/// Fills the lanes of `which`, which have hit polygons of one kind, and returns those of them that were plain.
/// polygons, at: the kind's blocks, and each lane's place in them.
FN maskw flat_surfaces_w(const Scene* scene, const SurfaceHits_w* hits, maskw which, GLOBAL const real* polygons,
                         intw at, int corners, Surfaces_w* s, HitParameters_w* parameters) {
  real3w a = gather_planes3_w(polygons, at, 0, SCENE_LANES), b = gather_planes3_w(polygons, at, 3, SCENE_LANES);
  real3w last = gather_planes3_w(polygons, at, 3 * (corners - 1), SCENE_LANES), e = sub3_w(b, a), f = sub3_w(last, a);
  Real2_w sa = shear_each_w(hits, a), sb = shear_each_w(hits, b), sl = shear_each_w(hits, last);
  realw ea = edge_each_w(sb, sl), eb = edge_each_w(sl, sa), el = edge_each_w(sa, sb), sum = ea + eb + el;
  realw u = within_one_w(eb / sum), v = within_one_w(el / sum), one = splat_w(R(1.0)), zero = splat_w(R(0.0));
  real3w p = add3_w(fma3_w(u, e, scale3_w(v, f)), a);
  real3w normal = normalize3_w(cross3_w(e, f));
  realw facing = dot3_w(normal, hits->d), bound = zero, off = zero;
  real3w edge_u = e, edge_v = f;
  if (!TIER_FAST) {
    realw size = edges_size_w(e, f), across = abs_w(dot3_w(normal, plain_cross3_w(e, f)));
    NearPoint_w near = near_point_w(hits, a, e, f, normal, facing, size, across,
                                    splat_w(R(1.75) * real_roundoff()) * (max3_w(abs3_w(p)) + size));
    p = sel3_w(near.which, near.p, p);
    off = sel_w(near.which & ~hits->is_placed, near.off, zero);
  }
  p = hit_point_to_world_w(hits, p);
  normal = hit_normal_to_world_w(hits, normal);
#if TIER_FAST
  p = fma3_w(hits->world_t, hits->world_d, hits->world_o);
#endif
  maskw plain = which & finite3_w(p) & finite3_w(normal) & finite_w(facing);
  if (!TIER_FAST & !REPORTS_HITS) {  // departure_bound, is_amid.
    if (HAS_INSTANCES && any_w(hits->is_placed)) {
      a = hit_point_to_world_w(hits, a);
      e = sub3_w(hit_point_to_world_w(hits, b), a);
      f = sub3_w(hit_point_to_world_w(hits, last), a);
    }
    realw size = edges_size_w(e, f), across = abs_w(dot3_w(normal, plain_cross3_w(e, f)));
    bound = departure_bound_w(scene, hits, max3_w(abs3_w(p)) + size);
    realw least = sel_w(lt_w(u, v), u, v), u_rest = one - u, v_rest = one - v, both_rest = u_rest - v;
    if (corners == 3) {
      least = sel_w(lt_w(both_rest, least), both_rest, least);
    } else {
      least = sel_w(lt_w(u_rest, least), u_rest, least);
      least = sel_w(lt_w(v_rest, least), v_rest, least);
    }
    plain = plain & lt_w(splat_w(R(16.0)) * bound * size, least * across);
    bound = sel_w(lt_w(zero, off), off, bound);
  }
  take_surfaces_w(scene, hits, plain, p, normal, facing, bound, s);
  take_parameters_w(plain, u, v, edge_u, edge_v, parameters);
  return plain;
}

FN maskw triangle_surfaces_w(const Scene* scene, const SurfaceHits_w* hits, maskw which, GLOBAL const real* polygons,
                             intw at, Surfaces_w* s, HitParameters_w* parameters) {
  return flat_surfaces_w(scene, hits, which, polygons, at, 3, s, parameters);
}

FN maskw parallelogram_surfaces_w(const Scene* scene, const SurfaceHits_w* hits, maskw which,
                                  GLOBAL const real* polygons, intw at, Surfaces_w* s, HitParameters_w* parameters) {
  return flat_surfaces_w(scene, hits, which, polygons, at, 4, s, parameters);
}
