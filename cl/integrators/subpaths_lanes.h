// SPDX-License-Identifier: MIT
// Vertices of the two subpaths of bidirectional path tracing: both are found, passed and left by the same functions.
// One width; no guard.
#include "integrators/techniques_lanes.h"

typedef struct {
  maskw which;  ///< Lanes that have one here; the others of `passed` go on behind it.
  maskw passed;
  Surfaces_w s;
  real3w back;     ///< Unit, to the vertex before.
  real3w carried;  ///< Of a light's subpath the flux that comes there, of the camera's its throughput.
  realw number;    ///< Which of the materials of a blend.
  intw depth;      ///< Edges before it; from the camera one more.
  Techniques_w t;
} Vertex_w;

/// Where a light's subpath begins.
typedef struct {
  Surfaces_w s;
  intw lights;
  maskw is_surface, is_far;
} LightEnd_w;

/// f |cos| for light from `in` to `out`, both unit, without delta lobes, and the density with which a path that comes
/// from `out` draws `in`.
SELDOM_FN void vertex_share_w(const Scene* scene, const Vertex_w* v, maskw which, real3w out, real3w in, real3w* value,
                              realw* density) {
  MaterialRows_w at = rows_at_w(scene, &v->s, which, out, v->number);
  Bsdf_w b = bsdf_at_w(scene, &v->s, &at, out);
  *value = bsdf_eval_w(&b, in, density);
}

/// Only the density.
FN realw reverse_density_w(const Scene* scene, const Vertex_w* v, maskw which, real3w out, real3w in) {
  real3w value;
  realw density;
  vertex_share_w(scene, v, which, out, in, &value, &density);
  return density;
}

/// Of a direction and the surface.
FN realw cosine_at_w(const Vertex_w* v, real3w way) { return abs_w(dot3_w(v->s.normal, way)); }

SELDOM_FN void find_vertex_w(const Scene* scene, Paths_w* path, Surfaces_w* s) {
  const FirstSamples none = {0, 0, 0, 0, 0, 0u};
  *s = find_surfaces_w(scene, path, FIND_NEAREST_APPROXIMATELY, &none);
}

/// What a first ray's density is over: that with which a vertex on the surface draws the place on the light instead.
FN realw light_edge_w(const Scene* scene, const LightEnd_w* end, const Vertex_w* v, realw distance2) {
  real3w towards = sub3_w(end->s.position, v->s.position);
  maskw which = v->which & end->is_surface;
  realw drawn = light_density_w(scene, which, end->lights, v->s.position, towards, &end->s);
  return sel_w(end->is_surface, drawn, sel_w(end->is_far, splat_w(R(1.0)), distance2));
}

/// Makes vertices of v->s, at which fewer than `most` surfaces come before. The path passes hidden emitters, and some
/// masks. end: of a light's subpath, else 0; lens: of the camera's.
FN void arrive_vertex_w(const Scene* scene, Paths_w* path, const LightEnd_w* end, Real2_w lens, int most,
                        Techniques_w* t, Vertex_w* v) {
  v->which = path->alive & v->s.hit & lt_int_w(path->depth, splat_int_w(most));
  v->passed = passes_on_w(scene, path, &v->s, v->which);
  v->which = v->which & ~v->passed;
  v->back = unit3_w(negate3_w(real3_at_w(path->rays.planes + RAY_PLANE_D)));
  v->number = splat_w(R(0.0));
  if (HAS_BLEND) v->number = random_between_w(vertex_number_w(scene, &path->sample, path->depth, USE_BLEND));
  v->depth = path->depth;
  if (HAS_MASK) {
    MaterialRows_w at = rows_at_w(scene, &v->s, v->which, v->back, v->number);
    maskw open = passes_masks_w(scene, path, &at, v->which);
    t->last = sel_w(open, splat_w(R(0.0)), t->last);
    PRIVATE realw* t_max = &path->rays.planes[RAY_PLANE_T_MAX];
    *t_max = unclipped_w(open, *t_max);
    v->passed = v->passed | open;
    v->which = v->which & ~open;
  }
  if (HAS_STRICT_NORMALS) v->which = on_one_side_w(scene, &v->s, v->which, v->back);
  v->carried = end ? mul3_w(path->radiance, path->throughput) : path->throughput;
  if (any_w(v->which)) {
    real3w off = sub3_w(v->s.position, path->from);
    realw area = dot3_w(off, off);
    maskw is_first = ~lt_int_w(splat_int_w(end ? 1 : 0), v->depth);
    if (any_w(v->which & is_first)) {
      realw first = end ? light_edge_w(scene, end, v, area)
                        : splat_w(R(1.0)) / sensor_way_w(scene, v->which, v->s.position, lens).gain;
      area = sel_w(is_first, first, area);
    }
    techniques_arrive_w(v->which, area, cosine_at_w(v, v->back), t);
  }
  v->t = *t;
}

/// The path leaves the vertices, or goes on behind what it passes.
SELDOM_FN void leave_vertex_w(const Scene* scene, Paths_w* path, const Vertex_w* v, int is_adjoint, Techniques_w* t) {
  int next = 0;
  real3w d = real3_at_w(path->rays.planes + RAY_PLANE_D), way = d;
  realw t_max = path->rays.planes[RAY_PLANE_T_MAX] - v->s.t;
  path->alive = v->which;
  maskw on = bdpt_step_w(scene, path, &v->s, &next);
  if (any_w(on)) {
    MaterialRows_w at = rows_at_w(scene, &v->s, on, v->back, v->number);
    Bsdf_w b = bsdf_at_w(scene, &v->s, &at, v->back);
    on = path_scatter_w(scene, path, &v->s, &b, on, is_adjoint ? next | STEP_ADJOINT : next, &way);
    if (HAS_COUNT_RAYS) count_events(scene, COUNT_BOUNCE, lanes_among(bits_w(on)));
    maskw is_spread = on & lt_w(splat_w(R(0.0)), path->density);
    realw reverse = splat_w(R(0.0));
    if (any_w(is_spread)) reverse = reverse_density_w(scene, v, is_spread, way, v->back);
    maskw is_first = ~lt_int_w(splat_int_w(is_adjoint), v->depth);
    // A path that goes straight on keeps its direction, of any length.
    techniques_turn_w(on, is_first, path->density, reverse, cosine_at_w(v, unit3_w(way)), t);
    way = sel3_w(on, way, d);
    t_max = unclipped_w(on, t_max);
    path->depth = sel_int_w(on, path->depth + splat_int_w(1), path->depth);
  }
  path->alive = on | v->passed;
  if (any_w(path->alive)) rays_passing_w(&v->s, path->alive, v->passed, way, t_max, &path->rays);
}

SELDOM_FN void free_lanes_w(const Scene* scene, Rays_w* rays, maskw which, maskw* is_free) {
  if (HAS_COUNT_RAYS) count_events(scene, COUNT_SHADOW, lanes_among(bits_w(which)));
  *is_free = which & ~meets_any_w(scene, rays, which);
}
