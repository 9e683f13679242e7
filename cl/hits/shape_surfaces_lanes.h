// SPDX-License-Identifier: MIT
// The part of plain_surfaces_lanes.h that shapes compute: points, normals, u and v. One width; no guard.
#include "hits/surface_hits_lanes.h"
#include "shapes/all_surfaces_lanes.h"

/// NAME_SURFACES of a shape whose surfaces are computed one by one.
FN maskw alone_surfaces_w(const Scene* scene, const SurfaceHits_w* hits, maskw which, GLOBAL const real* blocks,
                          intw at, Surfaces_w* s, HitParameters_w* parameters) {
  (void)scene;
  (void)hits;
  (void)which;
  (void)blocks;
  (void)at;
  (void)s;
  (void)parameters;
  return none_w();
}

/// Fills the surfaces of the shapes that have a body, and returns the lanes that are complete.
FN maskw shape_surfaces_w(const Scene* scene, const SurfaceHits_w* hits, Surfaces_w* s, HitParameters_w* at) {
  maskw which, plain = none_w();
  (void)which;  // A scene without shapes.
  (void)scene;
  (void)s;
  at->u = at->v = splat_w(R(0.0));
  at->has_edges = none_w();
  at->edge_u = at->edge_v = hits->o;
#define SHAPE(name, planes)                                                                             \
  which = s->hit & ~nonzero_w(hits->kind - splat_int_w(SHAPE_##name));                                  \
  if (any_w(which)) {                                                                                   \
    GLOBAL const real* blocks = scene->geometry + scene_shape_row(scene, SHAPE_##name)[SHAPE_GEOMETRY]; \
    intw place = hit_places_w(scene, hits, which, SHAPE_##name, planes, s);                             \
    plain = plain | name##_SURFACES(scene, hits, which, blocks, place, s, at);                          \
  }
#include "shapes/shapes.def"
#undef SHAPE
  return plain;
}
