// SPDX-License-Identifier: MIT
// The surface points that the rays of LANES paths have hit, as shading uses them, and how rays leave them. Frame: the
// one the scene was uploaded in. One width; no guard.
#include "hits/departure.h"
#include "scene/scene.h"

typedef struct {
  maskw hit;                         ///< The other lanes are undefined, except `part`, which is a row of the table.
  realw t;                           ///< In units of the ray's prepared direction.
  real3w position, normal, shading;  ///< As in hits/surface.h.
  real3w along;                      ///< Kept only with TANGENT.
  real3w grad_u, grad_v;             ///< Kept only with RELIEF.
  realw facing;
  realw tex_u, tex_v, footprint;  ///< Kept only where there are textures.
  realw own_u, own_v;             ///< The shape's own u, v; kept only with MESH_ATTRIBUTE.
  intw part, id, instance;        ///< id: the primitive's, scene-wide.
  intw is_round, is_flipped;      ///< Kept only where a surface may be round.
  real3w point, move;             ///< As in hits/departure.h.
  realw bound;
#if HAS_MEDIA
  maskw scatters;  ///< Lanes where the path scatters in a medium before the surface (media/vertex_lanes.h).
#endif
} Surfaces_w;

FN void put_real3_w(PRIVATE real3w* to, int lane, real3 v) {
  put_w(&to->x, lane, v.x);
  put_w(&to->y, lane, v.y);
  put_w(&to->z, lane, v.z);
}

FN Surfaces_w surfaces_none_w(void) {
  Surfaces_w s;
  realw zero = splat_w(R(0.0));
  s.hit = none_w();
  s.t = s.facing = s.tex_u = s.tex_v = s.own_u = s.own_v = s.footprint = s.bound = zero;
  s.position = s.normal = s.shading = s.along = s.grad_u = s.grad_v = s.point = s.move = vec3_w(zero, zero, zero);
  s.part = s.id = s.is_round = s.is_flipped = splat_int_w(0);
  s.instance = splat_int_w(-1);
#if HAS_MEDIA
  s.scatters = none_w();
#endif
  return s;
}

#if HAS_MEDIA
/// Surfaces of the lanes of `which`.
FN void sel_surfaces_w(maskw which, const Surfaces_w* from, Surfaces_w* to) {
  to->hit = (from->hit & which) | (to->hit & ~which);
  to->t = sel_w(which, from->t, to->t);
  to->position = sel3_w(which, from->position, to->position);
  to->normal = sel3_w(which, from->normal, to->normal);
  to->shading = sel3_w(which, from->shading, to->shading);
  to->facing = sel_w(which, from->facing, to->facing);
  if (HAS_TANGENT) to->along = sel3_w(which, from->along, to->along);
  if (HAS_RELIEF) {
    to->grad_u = sel3_w(which, from->grad_u, to->grad_u);
    to->grad_v = sel3_w(which, from->grad_v, to->grad_v);
  }
  if (TEXTURE_COUNT > 0) {
    to->tex_u = sel_w(which, from->tex_u, to->tex_u);
    to->tex_v = sel_w(which, from->tex_v, to->tex_v);
    to->footprint = sel_w(which, from->footprint, to->footprint);
  }
  if (HAS_MESH_ATTRIBUTE) {
    to->own_u = sel_w(which, from->own_u, to->own_u);
    to->own_v = sel_w(which, from->own_v, to->own_v);
  }
  to->part = sel_int_w(which, from->part, to->part);
  to->id = sel_int_w(which, from->id, to->id);
  to->instance = sel_int_w(which, from->instance, to->instance);
  to->is_round = sel_int_w(which, from->is_round, to->is_round);
  to->is_flipped = sel_int_w(which, from->is_flipped, to->is_flipped);
  to->point = sel3_w(which, from->point, to->point);
  to->move = sel3_w(which, from->move, to->move);
  to->bound = sel_w(which, from->bound, to->bound);
}
#endif

FN void surface_to_w(Surfaces_w* to, int lane, const Surface* s, int id, real t) {
  Departure departure = departure_of(s);
  put_w(&to->t, lane, t);
  put_real3_w(&to->position, lane, s->position);
  put_real3_w(&to->normal, lane, s->normal);
  put_real3_w(&to->shading, lane, s->shading);
  put_w(&to->facing, lane, s->facing);
  if (HAS_TANGENT) put_real3_w(&to->along, lane, s->along);
  if (HAS_RELIEF) {
    put_real3_w(&to->grad_u, lane, s->grad_u);
    put_real3_w(&to->grad_v, lane, s->grad_v);
  }
  if (TEXTURE_COUNT > 0) {
    put_w(&to->tex_u, lane, s->tex_u);
    put_w(&to->tex_v, lane, s->tex_v);
    put_w(&to->footprint, lane, s->footprint);
  }
  if (HAS_MESH_ATTRIBUTE) {
    put_w(&to->own_u, lane, s->u);
    put_w(&to->own_v, lane, s->v);
  }
  put_int_w(&to->part, lane, s->part);
  put_int_w(&to->id, lane, id);
  if (HAS_INSTANCES) put_int_w(&to->instance, lane, s->instance);
  put_int_w(&to->is_round, lane, s->outline == OUTLINE_ROUND);
  put_int_w(&to->is_flipped, lane, s->is_flipped);
  put_real3_w(&to->point, lane, departure.point);
  put_real3_w(&to->move, lane, departure.move);
  put_w(&to->bound, lane, departure.bound);
}

/// Lanes at a surface. A path that scatters before it stands in the record, too, perhaps in a scene without any part.
FN maskw at_surfaces_w(const Surfaces_w* s) {
#if HAS_MEDIA
  return s->hit & ~s->scatters;
#else
  return s->hit;
#endif
}

/// PART_... of each lane's part.
FN intw part_entry_w(const Scene* scene, const Surfaces_w* s, int entry) {
  return gather_int_w(scene->index + scene->index[HEADER_PARTS] + entry, s->part * (int)PART_INTS);
}

/// Rays from the surfaces towards d, until t_max, in the lanes of `which`; the rays of other lanes can hit nothing.
FN void rays_leaving_w(const Surfaces_w* s, maskw which, real3w d, realw t_max, Rays_w* rays) {
  realw zero = splat_w(R(0.0)), one = splat_w(R(1.0)), cosine = dot3_w(d, s->normal);
  realw off = sel_w(lt_w(cosine, zero), -s->bound, s->bound);
  real3w moved = add3_w(s->point, fma3_w(off, s->normal, s->move));
  real3w from = sel3_w(lt_w(zero, s->bound), moved, s->point);
  rays_make_w(from, d, sel_w(which, zero, one), sel_w(which, t_max, -one), which, rays);
  rays->departed = s->id;
  rays->departed_instance = s->instance;
  rays->aim = splat_int_w(-1);
  maskw outwards = ~lt_w(cosine, zero), inwards = ~lt_w(zero, cosine), is_flipped = nonzero_w(s->is_flipped);
  maskw is_outward = nonzero_w(s->is_round) & ((is_flipped & inwards) | (~is_flipped & outwards));
  rays->is_outward = sel_int_w(is_outward, splat_int_w(1), splat_int_w(0));
}

/// The rays of `which` begin `off` farther along their prepared directions.
FN void rays_begin_later_w(Rays_w* rays, maskw which, realw off) {
  for (int k = 0; k < 3; ++k) {
    PRIVATE realw* o = rays->planes + RAY_PLANE_O + k;
    *o = sel_w(which, fma_w(off, rays->planes[RAY_PLANE_D + k], *o), *o);
  }
}

/// How far apart two surfaces at p are at the most that lie on one another but for the rounding of their points: ample,
/// but for shapes that are thirty times as large as their way from the camera.
FN realw twins_apart_w(real3w p) {
  return splat_w(REAL_BITS == 64 ? R(0x1p-47) : R(0x1p-18)) * largest_of_w(p.x, p.y, p.z);
}

/// As rays_leaving_w, of rays that go straight on behind the surfaces `passed`. Two that lie on one another are met
/// once each: a ray that has come from one to the other at once could meet both in turns without an end, so it goes on
/// from a little farther.
FN void rays_passing_w(const Surfaces_w* s, maskw which, maskw passed, real3w d, realw t_max, Rays_w* rays) {
  rays_leaving_w(s, which, d, t_max, rays);
  if (!any_w(passed)) return;
  realw off = twins_apart_w(s->position);
  maskw is_at_once = passed & le_w(s->t, off);
  if (any_w(is_at_once)) rays_begin_later_w(rays, is_at_once, off);
}
