// SPDX-License-Identifier: MIT
// What the rays of LANES paths meet, in a scene packed for SCENE_LANES. One width; no guard.
#include "film/first_sample.h"
#include "textures/footprint.h"
#include "shapes/shape.h"

/// Of the width that the scene was packed for.
#define SCENE_LANED(name) SCENE_LANED_EXPAND(name, SCENE_LANES)
#define SCENE_LANED_EXPAND(name, lanes) SCENE_LANED_PASTE(name, lanes)
#define SCENE_LANED_PASTE(name, lanes) name##_w_##lanes

/// Lanes whose values beside the picture are stored.
FN maskw are_first_w(const FirstSamples* first) {
  return nonzero_w(int_of_uint_w(splat_uint_w(first->lanes) >> lane_numbers_w() & 1u));
}

/// The surface where a path's ray ends, for shading.
FN void take_surface_w(const Scene* scene, Paths_w* path, int lane, const Ray* ray, const Nearest* nearest,
                       const FirstSamples* first, Surfaces_w* to) {
  int is_hit = nearest->kind >= 0;
  Surface s = surface_none();
  if (is_hit) {
    s = surface_at(scene, ray, nearest, SCENE_LANES);
    if (TEXTURE_COUNT > 0) {
      real travelled = get_w(&path->travelled, lane) + length3(sub3(s.position, ray->o));
      put_w(&path->travelled, lane, travelled);
      s.footprint = pixel_footprint(scene, travelled, &s, ray->d);
    }
    surface_to_w(to, lane, &s, nearest->id, nearest->t);
  }
  if (is_first_sample(first, lane)) {
    int pixel = get_int_w((PRIVATE const intw*)&path->sample.pixel, lane);
    store_first_sample(first, pixel, ray, is_hit, nearest->t, &s);
  }
}

#if LANES == 1
/// want: FIND_NEAREST or FIND_NEAREST_APPROXIMATELY.
FN Surfaces_w find_surfaces_w(const Scene* scene, Paths_w* path, int want, const FirstSamples* first) {
  Surfaces_w s = surfaces_none_w();
  Ray ray = ray_of_w(&path->rays, 0);
  Nearest nearest = SCENE_LANED(closest_hit)(scene, &ray, want);
  s.hit = -(int)(nearest.kind >= 0);
  take_surface_w(scene, path, 0, &ray, &nearest, first, &s);
  return s;
}

/// The lanes of `which` whose rays meet anything within their range.
FN maskw meets_any_w(const Scene* scene, Rays_w* rays, maskw which) {
  Ray ray = ray_of_w(rays, 0);
  return which & -(int)(SCENE_LANED(any_hit)(scene, &ray) != 0);
}
#else
/// As widened_w of accel/traverse.h. A list of media's boundaries is no tree, but the rays may have been widened for
/// the scene's own, which reaches less far, and packets reject a list's polygons by their boxes.
FN void widen_w(const Scene* scene, Rays_w* rays) {
  int is_walked = HAS_INSTANCES || scene_met(scene) != 0 || scene_root(scene) != NO_REFERENCE;
  GLOBAL const real* reach = scene_reach(scene);
  maskw has_departed = nonzero_w(rays->departed + splat_int_w(1));
  if (HAS_TREE && is_walked) widen_rays_w(has_departed, rays->planes, reach);
}

#include "hits/plain_surfaces_lanes.h"

/// take_surface_w for the lanes that plain_surfaces_w leaves: seldom, so that it is called.
SELDOM_FN void take_surface_alone_w(const Scene* scene, Paths_w* path, int lane, const Ray* ray, const Nearest* nearest,
                                    const FirstSamples* first, Surfaces_w* to) {
  take_surface_w(scene, path, lane, ray, nearest, first, to);
}

FN Surfaces_w find_surfaces_w(const Scene* scene, Paths_w* path, int want, const FirstSamples* first) {
  Surfaces_w s = surfaces_none_w();
  // Rays that nobody made, and those of paths that have ended, must not be walked: with all planes 0 one meets every
  // node of the tree.
  PRIVATE realw* t_max = path->rays.planes + RAY_PLANE_T_MAX;
  *t_max = sel_w(path->alive, *t_max, splat_w(-R(1.0)));
  widen_w(scene, &path->rays);
  NearestEach_w each = packet_traverse_w(scene, &path->rays, want);
  s.hit = path->alive & ~lt_int_w(each.kind, splat_int_w(0));
  realw travelled = path->travelled;
  maskw is_plain = plain_surfaces_w(scene, path, &each, &s);
  if (HAS_AOV) {  // Surfaces that are reported are computed whole.
    is_plain = is_plain & ~are_first_w(first);
    if (TEXTURE_COUNT > 0) path->travelled = sel_w(is_plain, path->travelled, travelled);
  }
  maskw single = path->alive & ~is_plain;
  for (uint lanes = bits_w(single); lanes != 0u; lanes &= lanes - 1u) {
    int lane = first_bit(lanes);
    Ray ray = ray_of_w(&path->rays, lane);
    Nearest nearest = nearest_of_w(&each, lane);
    take_surface_alone_w(scene, path, lane, &ray, &nearest, first, &s);
  }
  return s;
}

FN maskw meets_any_w(const Scene* scene, Rays_w* rays, maskw which) {
  widen_w(scene, rays);
  NearestEach_w each = packet_traverse_w(scene, rays, FIND_ANY);
  return which & ~lt_int_w(each.kind, splat_int_w(0));
}
#endif
