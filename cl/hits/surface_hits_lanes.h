// SPDX-License-Identifier: MIT
// What the surfaces of LANES hits are computed from: surface_at of shapes/shape.h in lanes, for the kinds that have a
// body (shapes/all_surfaces_lanes.h). One width; no guard.

/// The rays, in the frame of the group that each has hit, and what they hit.
typedef struct {
  real3w o, d;
  realw shear_x, shear_y, t;
  maskw is_x, is_y;  ///< Lanes whose largest axis of d is x, y.
  intw kind, slot, id, instance;
  maskw is_placed;        ///< Lanes that have hit something of an instance,
  intw placed;            ///< and where its INSTANCE_REALS begin in the geometry; 0 elsewhere.
  Placement_w placement;  ///< Undefined where no lane has.
  real3w world_o, world_d;
  realw world_t;
} SurfaceHits_w;

FN SurfaceHits_w surface_hits_w(const Scene* scene, const Rays_w* rays, const NearestEach_w* each, maskw which) {
  SurfaceHits_w hits;
  PRIVATE const realw* planes = rays->planes;
  hits.kind = each->kind;
  hits.slot = each->slot;
  hits.id = each->id;
  hits.instance = each->instance;
  hits.world_o = hits.o = real3_at_w(planes + RAY_PLANE_O);
  hits.world_d = hits.d = real3_at_w(planes + RAY_PLANE_D);
  hits.world_t = hits.t = each->t;
  realw kz = planes[RAY_PLANE_SHEAR];
  hits.shear_x = planes[RAY_PLANE_SHEAR + 1];
  hits.shear_y = planes[RAY_PLANE_SHEAR + 2];
  hits.is_x = eq_w(kz, splat_w(R(0.0)));
  hits.is_y = eq_w(kz, splat_w(R(1.0)));
  hits.is_placed = none_w();
  hits.placed = splat_int_w(0);
  if (!HAS_INSTANCES) return hits;
  hits.is_placed = which & ~lt_int_w(each->instance, splat_int_w(0));
  if (!any_w(hits.is_placed)) return hits;
  intw first = splat_int_w(scene_shape_row(scene, SHAPE_COUNT)[SHAPE_GEOMETRY]);
  hits.placed = sel_int_w(hits.is_placed, first + each->instance * (int)INSTANCE_REALS, splat_int_w(0));
  hits.placement = gather_placement_w(scene->geometry, hits.placed);
  real3w o = hits.o, d = hits.d;
  ray_into_group_w(&hits.placement.rows, &o, &d);
  Rays_w within;
  rays_make_w(o, d, planes[RAY_PLANE_T_MIN], splat_w(REAL_MAX), none_w(), &within);
  kz = within.planes[RAY_PLANE_SHEAR];
  hits.o = sel3_w(hits.is_placed, o, hits.o);
  hits.d = sel3_w(hits.is_placed, real3_at_w(within.planes + RAY_PLANE_D), hits.d);
  hits.t = sel_w(hits.is_placed, hits.t / within.planes[RAY_PLANE_T_FROM_SCALED], hits.t);
  hits.shear_x = sel_w(hits.is_placed, within.planes[RAY_PLANE_SHEAR + 1], hits.shear_x);
  hits.shear_y = sel_w(hits.is_placed, within.planes[RAY_PLANE_SHEAR + 2], hits.shear_y);
  hits.is_x = (hits.is_placed & eq_w(kz, splat_w(R(0.0)))) | (~hits.is_placed & hits.is_x);
  hits.is_y = (hits.is_placed & eq_w(kz, splat_w(R(1.0)))) | (~hits.is_placed & hits.is_y);
  return hits;
}

FN real3w hit_point_to_world_w(const SurfaceHits_w* hits, real3w p) {
  if (!HAS_INSTANCES || !any_w(hits->is_placed)) return p;
  return sel3_w(hits->is_placed, point_to_world_w(&hits->placement, p), p);
}

/// A unit normal; stays as it is where nothing is placed.
FN real3w hit_normal_to_world_w(const SurfaceHits_w* hits, real3w n) {
  if (!HAS_INSTANCES || !any_w(hits->is_placed)) return n;
  return sel3_w(hits->is_placed, normalize3_w(normal_to_world_w(&hits->placement, n)), n);
}

FN maskw finite3_w(real3w v) { return finite_w(v.x) & finite_w(v.y) & finite_w(v.z); }

/// 1: hits are reported with u and v (hits/describe_lanes.h).
#ifndef REPORTS_HITS
#define REPORTS_HITS 0
#endif

/// Whether textures or reports ask for u and v of shapes other than polygons.
enum { ASKS_COORDINATES_w = TEXTURE_COUNT > 0 || REPORTS_HITS };

/// u, v of the hits, for smooth normals, textures and reports.
typedef struct {
  realw u, v;
  maskw has_edges;        ///< Lanes of polygons,
  real3w edge_u, edge_v;  ///< along whose edges they grow, in the frame of the group; kept only with TANGENT or RELIEF.
} HitParameters_w;

/// As in surface_keep_finite of hits/surface.h.
FN void take_coordinates_w(maskw plain, realw u, realw v, HitParameters_w* to) {
  realw zero = splat_w(R(0.0));
  to->u = sel_w(plain, sel_w(finite_w(u), u, zero), to->u);
  to->v = sel_w(plain, sel_w(finite_w(v), v, zero), to->v);
}

FN void take_parameters_w(maskw plain, realw u, realw v, real3w edge_u, real3w edge_v, HitParameters_w* to) {
  to->u = sel_w(plain, u, to->u);
  to->v = sel_w(plain, v, to->v);
  to->has_edges = to->has_edges | plain;
  if (HAS_TANGENT + HAS_RELIEF == 0) return;
  to->edge_u = sel3_w(plain, edge_u, to->edge_u);
  to->edge_v = sel3_w(plain, edge_v, to->edge_v);
}

/// Sets the parts of the lanes of `which`, which have hit a kind of so many planes; returns where each lane's primitive
/// begins in the kind's blocks, a valid place in the other lanes.
FN intw hit_places_w(const Scene* scene, const SurfaceHits_w* hits, maskw which, int kind, int planes, Surfaces_w* s) {
  GLOBAL const int* row = scene_shape_row(scene, kind);
  intw slot = sel_int_w(which, hits->slot, splat_int_w(0)), lane = slot % SCENE_LANES;
  intw part = gather_int_w(scene->index + row[SHAPE_IDS] + row[SHAPE_BLOCKS] * SCENE_LANES, slot);
  s->part = sel_int_w(which, part, s->part);
  return (slot - lane) * planes + lane;
}

/// Where the numbers of the lanes' triangles begin among those of their meshes' corners, so many a triangle; entry: the
/// PART_... that says where a mesh's are. *which loses the lanes whose mesh has none.
FN intw mesh_corners_w(const Scene* scene, const SurfaceHits_w* hits, const Surfaces_w* s, int entry, int reals,
                       PRIVATE maskw* which) {
  intw first = part_entry_w(scene, s, entry), zero = splat_int_w(0);
  *which = *which & ~lt_int_w(first, zero);
  if (!any_w(*which)) return zero;
  intw triangle = hits->id - part_entry_w(scene, s, PART_FIRST_ID);
  return sel_int_w(*which, first + triangle * reals, zero);
}

/// departure_bound of hits/departure.h.
FN realw departure_bound_w(const Scene* scene, const SurfaceHits_w* hits, realw reach) {
  if (HAS_INSTANCES) {
    realw error = gather_w(scene->geometry + INSTANCE_ERROR, hits->placed);
    reach = sel_w(hits->is_placed, reach + error, reach);
  }
  return splat_w(R(1.75) * real_roundoff()) * reach;
}

/// Takes the surfaces of a kind, in the world, in the lanes of `plain`. normal, facing: as the shape has them. bound:
/// as in hits/departure.h, of surfaces that rays leave from their position.
INLINE_FN void take_surfaces_w(const Scene* scene, const SurfaceHits_w* hits, maskw plain, real3w position,
                               real3w normal, realw facing, realw bound, Surfaces_w* s) {
  maskw is_flipped = nonzero_w(part_entry_w(scene, s, PART_FLIP));
  normal = sel3_w(is_flipped, negate3_w(normal), normal);
  s->t = sel_w(plain, hits->world_t, s->t);
  s->position = sel3_w(plain, position, s->position);
  s->normal = sel3_w(plain, normal, s->normal);
  s->shading = sel3_w(plain, normal, s->shading);
  s->facing = sel_w(plain, sel_w(is_flipped, -facing, facing), s->facing);
  s->id = sel_int_w(plain, hits->id, s->id);
  if (HAS_INSTANCES) s->instance = sel_int_w(plain, hits->instance, s->instance);
  s->is_flipped = sel_int_w(plain & is_flipped, splat_int_w(1), s->is_flipped);
  s->point = sel3_w(plain, position, s->point);
  s->bound = sel_w(plain, bound, s->bound);
}

/// The same, of points and normals in the frame of the group. Returns the lanes of `which` where all of it is finite.
INLINE_FN maskw take_own_surfaces_w(const Scene* scene, const SurfaceHits_w* hits, maskw which, real3w position,
                                    real3w normal, realw facing, realw bound, Surfaces_w* s) {
  position = hit_point_to_world_w(hits, position);
  normal = hit_normal_to_world_w(hits, normal);
#if TIER_FAST
  position = fma3_w(hits->world_t, hits->world_d, hits->world_o);
#endif
  maskw plain = which & finite3_w(position) & finite3_w(normal) & finite_w(facing);
  take_surfaces_w(scene, hits, plain, position, normal, facing, bound, s);
  return plain;
}

/// As round_departure_bound of hits/departure.h, of a round shape of that size.
FN realw round_departure_bound_w(const Scene* scene, const SurfaceHits_w* hits, realw size) {
  realw zero = splat_w(R(0.0)), off = splat_w(round_off(R(1.0))) * size;
  if (TIER_FAST) return zero;
  if (!HAS_INSTANCES) return off;
  realw shrink = gather_w(scene->geometry + INSTANCE_SHRINK, hits->placed);
  return sel_w(hits->is_placed, off / shrink + departure_bound_w(scene, hits, zero), off);
}

/// The first reals of the frames of the lanes' shapes, 4 at least.
FN void gather_frame_w(const Scene* scene, const Surfaces_w* s, int reals, PRIVATE realw* frame) {
  intw at = part_entry_w(scene, s, PART_AXES), zero = splat_int_w(0);
  gather_row_w(scene->shading, sel_int_w(lt_int_w(at, zero), zero, at), reals, frame);
}
