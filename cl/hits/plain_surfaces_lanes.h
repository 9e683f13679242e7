// SPDX-License-Identifier: MIT
// Surfaces in lanes, for the cases that have a body: surface_at of shapes/shape.h, operation by operation.
// One width; no guard.
#include "hits/shape_surfaces_lanes.h"
#include "hits/surface_tangents_lanes.h"
#include "textures/footprint_lanes.h"

/// Three reals of each of a primitive's corners.
FN real3w interpolate_each_w(GLOBAL const real* corners, intw at, realw u, realw v) {
  realw w = splat_w(R(1.0)) - u - v, row[9];
  gather_row_w(corners, at, 9, row);
  return fma3_w(v, real3_at_w(row + 6), fma3_w(u, real3_at_w(row + 3), scale3_w(w, real3_at_w(row))));
}

/// Smooth normals in the lanes of `which`, where the mesh has any.
FN void smooth_each_w(const Scene* scene, const SurfaceHits_w* hits, maskw which, const HitParameters_w* at,
                      Surfaces_w* s) {
  intw place = mesh_corners_w(scene, hits, s, PART_NORMALS, 9, &which);
  if (!any_w(which)) return;
  real3w smooth = interpolate_each_w(scene->shading, place, at->u, at->v);
  if (HAS_INSTANCES && any_w(hits->is_placed))
    smooth = sel3_w(hits->is_placed, normal_to_world_w(&hits->placement, smooth), smooth);
  which = which & lt_w(splat_w(R(0.0)), dot3_w(smooth, smooth));
  maskw is_flipped = nonzero_w(part_entry_w(scene, s, PART_FLIP));
  smooth = normalize3_w(sel3_w(is_flipped, negate3_w(smooth), smooth));
  s->shading = sel3_w(which, smooth, s->shading);
}

/// Texture coordinates and footprints: as take_surface_w of find_lanes.h.
FN void texture_each_w(const Scene* scene, Paths_w* path, const SurfaceHits_w* hits, maskw which,
                       const HitParameters_w* at, Surfaces_w* s) {
  realw u = at->u, v = at->v;
  if (HAS_MESH_ATTRIBUTE) {
    s->own_u = sel_w(which, u, s->own_u);
    s->own_v = sel_w(which, v, s->own_v);
  }
  if (HAS_MESH_UVS) {
    maskw has_uvs = which;
    intw place = mesh_corners_w(scene, hits, s, PART_UVS, 6, &has_uvs);
    if (any_w(has_uvs)) {
      realw w = splat_w(R(1.0)) - u - v, uv[6];
      gather_row_w(scene->shading, place, 6, uv);
      realw tex_u = fma_w(v, uv[4], fma_w(u, uv[2], w * uv[0]));
      realw tex_v = fma_w(v, uv[5], fma_w(u, uv[3], w * uv[1]));
      u = sel_w(has_uvs, tex_u, u);
      v = sel_w(has_uvs, tex_v, v);
    }
  }
  s->tex_u = sel_w(which, u, s->tex_u);
  s->tex_v = sel_w(which, v, s->tex_v);
  realw travelled = path->travelled + length3_w(sub3_w(s->position, hits->world_o));
  path->travelled = sel_w(which, travelled, path->travelled);
  realw width = pixel_footprint_w(scene, path->travelled, s->normal, hits->world_d);
  if (HAS_INSTANCES) {
    realw shrink = gather_w(scene->geometry + INSTANCE_SHRINK, hits->placed);
    width = sel_w(hits->is_placed, width * shrink, width);
  }
  s->footprint = sel_w(which, width, s->footprint);
}

/// Fills the surfaces that can be computed in lanes, and returns the lanes that are complete.
FN maskw plain_surfaces_w(const Scene* scene, Paths_w* path, const NearestEach_w* each, Surfaces_w* s) {
  SurfaceHits_w hits = surface_hits_w(scene, &path->rays, each, s->hit);
  HitParameters_w at;
  maskw plain = shape_surfaces_w(scene, &hits, s, &at);
  if (HAS_SMOOTH_NORMALS) smooth_each_w(scene, &hits, plain, &at, s);
  if (HAS_TANGENT + HAS_RELIEF > 0) tangents_each_w(scene, &hits, plain, &at, s);
  if (TEXTURE_COUNT > 0) texture_each_w(scene, path, &hits, plain, &at, s);
  return plain | ~s->hit;
}
