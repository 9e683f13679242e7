// SPDX-License-Identifier: MIT
// Samples of bidirectional path tracing: a light's subpath, whose vertices are kept, then the camera's. What a sample
// brings to its own pixel is one splat; the vertices of the light's subpath go to any pixel as in ptracer, and each
// pixel's sum is that of the same replicate. The camera's subpath has the numbers of a sequence of its pixel's and
// sum's own; these come after the sequences of the light's subpaths. Needs integrators/light_begin_lanes.h. One width;
// no guard.
#include "integrators/connections_lanes.h"

/// The number of a sample's own pixel's splat (film/splat.h): after those of all vertices.
enum { LAST_SPLAT_w = 0x7fffffff };

/// Of the light's subpath, the latest last. One more is room for those that are not kept.
typedef struct {
  int count;
  Vertex_w at[LIGHT_VERTICES_w + 1];
} LightVertices_w;

/// Begins light subpaths. t: of their rays.
FN LightEnd_w light_end_w(const Scene* scene, Paths_w* path, const NewPaths_w* begun, Techniques_w* t) {
  LightEnd_w end;
  LightChoice_w choice;
  choice.light = splat_int_w(0);
  choice.rarity = splat_w(R(1.0));
  LightRay_w ray = light_paths_leave_w(scene, path, begun->which, begun->pixels, begun->numbers, &end.s, &choice);
  realw over = splat_w(R(1.0)) / light_spread_w(scene, path->alive, choice.light, ray.way);
  end.lights = choice.light;
  end.is_surface = ray.is_surface;
  end.is_far = ray.is_far;
  t->last = over;
  t->earlier = t->ends = choice.rarity * ray.inverse * over;
  path->from = end.s.position;
  path->depth = splat_int_w(1);
  return end;
}

/// Follows light subpaths to their ends, and joins every vertex with the sensor.
FN void follow_from_lights_w(const Scene* scene, Paths_w* path, const NewPaths_w* begun, LightVertices_w* light) {
  Techniques_w t;
  Real2_w none;
  LightEnd_w end = light_end_w(scene, path, begun, &t);
  none.x = none.y = splat_w(R(0.0));
  light->count = 0;
  while (any_w(path->alive)) {
    Vertex_w* v = &light->at[light->count];
    find_vertex_w(scene, path, &v->s);
    arrive_vertex_w(scene, path, &end, none, scene->index[HEADER_MAX_DEPTH], &t, v);
    join_with_sensor_w(scene, path, v);
    leave_vertex_w(scene, path, v, 1, &t);
    if (light->count < LIGHT_VERTICES_w) ++light->count;
  }
}

/// Camera rays through the samples' own pixels. Returns their places on the lens.
FN Real2_w camera_paths_begin_w(const Scene* scene, Paths_w* path, const NewPaths_w* begun, intw columns, intw rows) {
  PRIVATE const SplatFilm* film = scene->splats;
  GLOBAL const int* index = scene->index;
  intw numbers = (rows + splat_int_w(film->y)) * splat_int_w(index[HEADER_WIDTH]) + columns + splat_int_w(film->x);
  path->alive = none_w();
  uint sums = (uint)film->sums;
  uintw sequences = uint_of_int_w(numbers + splat_int_w(1)) * sums + (begun->numbers & (sums - 1u));
  path->sample = sequence_begin_w(scene, sequences, begun->numbers / sums, 1u);
  Real2_w offset = pixel_offset_w(scene, &path->sample), lens = lens_point_w(scene, &path->sample);
  Rays_w rays;
  film_rays_w(scene, columns, rows, offset, lens, &rays);
  paths_begin_w(scene, path, begun->which, &rays);
  return lens;
}

/// Follows camera subpaths to their ends, and gathers their radiance.
FN void follow_from_camera_w(const Scene* scene, Paths_w* path, Real2_w lens, const LightVertices_w* light) {
  int most = scene->index[HEADER_MAX_DEPTH];
  Techniques_w t;
  t.last = splat_w(R(1.0));
  t.earlier = t.ends = splat_w(R(0.0));
  while (most > 0 && any_w(path->alive)) {
    Vertex_w v;
    find_vertex_w(scene, path, &v.s);
    add_found_light_w(scene, path, &v.s, HEADER_BACKGROUND, light_along_w(scene, path, &v.s), &t);
    if (HAS_SUN) add_found_light_w(scene, path, &v.s, HEADER_SUN, sun_along_w(scene, path, &v.s), &t);
    arrive_vertex_w(scene, path, 0, lens, most - 1, &t, &v);
    if (any_w(v.which)) {
      add_drawn_light_w(scene, path, &v);
      for (int i = 0; i < light->count; ++i) add_connection_w(scene, path, &v, &light->at[i]);
    }
    leave_vertex_w(scene, path, &v, 0, &t);
  }
}

/// Whole samples, a lane each.
ONCE_FN void follow_both_ends_w(const Scene* scene, Paths_w* path, LightVertices_w* light, const NewPaths_w* begun) {
  PRIVATE const SplatFilm* film = scene->splats;
  follow_from_lights_w(scene, path, begun, light);
  uintw down = begun->pixels / (uint)film->columns;
  intw rows = int_of_uint_w(down), columns = int_of_uint_w(begun->pixels - down * (uint)film->columns);
  Real2_w lens = camera_paths_begin_w(scene, path, begun, columns, rows);
  follow_from_camera_w(scene, path, lens, light);
  maskw is_lit = begun->which & not_black_w(path->radiance);
  intw sums = int_of_uint_w(begun->numbers & ((uint)film->sums - 1u));
  for (uint lanes = bits_w(is_lit); lanes != 0u; lanes &= lanes - 1u) {
    int i = first_bit(lanes);
    add_own_light(scene, get_int_w(&columns, i), get_int_w(&rows, i), get_int_w(&sums, i), LAST_SPLAT_w,
                  get3_w(&path->radiance, i));
  }
}
