// SPDX-License-Identifier: MIT
// What the rays of LANES paths meet, in a scene packed for SCENE_LANES. One width; no guard.
#include "core/first_sample.h"
#include "core/footprint.h"
#include "shapes/shape.h"

/// Of the width that the scene was packed for.
#define SCENE_LANED(name) LANED_EXPAND(name, SCENE_LANES)

/// The surface where a path's ray ends, for shading.
FN void LANED(take_surface)(const Scene* scene, LANED(Paths) * path, int lane, const Ray* ray, const Nearest* nearest,
                            const FirstSample* first, LANED(Surfaces) * to) {
  int is_hit = nearest->kind >= 0;
  Surface s = surface_none();
  if (is_hit) {
    s = surface_at(scene, ray, nearest, SCENE_LANES);
    if (TEXTURE_COUNT > 0) {
      real travelled = get_w(&path->travelled, lane) + length3(sub3(s.position, ray->o));
      put_w(&path->travelled, lane, travelled);
      s.footprint = pixel_footprint(scene, travelled, &s, ray->d);
    }
    LANED(surface_to)(to, lane, &s, nearest->id, nearest->t);
  }
  if (HAS_AOV && lane == first->lane) store_first_sample(first, ray, is_hit, nearest->t, &s);
}

#if LANES == 1
/// want: FIND_NEAREST or FIND_NEAREST_ROUGHLY.
FN LANED(Surfaces) LANED(find_surfaces)(const Scene* scene, LANED(Paths) * path, int want, const FirstSample* first) {
  LANED(Surfaces) s = LANED(surfaces_none)();
  Ray ray = LANED(ray_of)(&path->rays, 0);
  Nearest nearest = SCENE_LANED(closest_hit)(scene, &ray, want);
  s.hit = -(int)(nearest.kind >= 0);
  LANED(take_surface)(scene, path, 0, &ray, &nearest, first, &s);
  return s;
}

/// The lanes of `which` whose rays meet anything within their range.
FN maskw LANED(meets_any)(const Scene* scene, LANED(Rays) * rays, maskw which) {
  Ray ray = LANED(ray_of)(rays, 0);
  return which & -(int)(SCENE_LANED(any_hit)(scene, &ray) != 0);
}
#else
/// As LANED(widened) of accel/traverse.h.
FN void LANED(widen)(const Scene* scene, LANED(Rays) * rays) {
  int is_walked = HAS_INSTANCES || scene->index[HEADER_ROOT] != NO_REFERENCE;
  GLOBAL const real* reach = scene->geometry + scene->index[HEADER_BOUNDS];
  maskw has_left = nonzero_w(rays->left + splat_int_w(1));
  if (HAS_TREE && is_walked) LANED(widen_rays)(has_left, rays->planes, reach);
}

#include "shapes/flat_surfaces_lanes.h"

/// Fills what can be done in lanes, and says where nothing is left to do.
FN maskw LANED(plain_surfaces)(const Scene* scene, const LANED(Rays) * rays, const LANED(NearestEach) * each,
                               LANED(Surfaces) * s) {
  LANED(FlatHits) hits;
  (void)scene;  // A scene without shapes.
  realw kz = rays->planes[RAY_PLANE_SHEAR];
  hits.o = LANED(real3_at)(rays->planes + RAY_PLANE_O);
  hits.d = LANED(real3_at)(rays->planes + RAY_PLANE_D);
  hits.shear_x = rays->planes[RAY_PLANE_SHEAR + 1];
  hits.shear_y = rays->planes[RAY_PLANE_SHEAR + 2];
  hits.is_x = eq_w(kz, splat_w(R(0.0)));
  hits.is_y = eq_w(kz, splat_w(R(1.0)));
  hits.t = read_w(each->t);
  hits.kind = read_int_w(each->kind);
  hits.slot = read_int_w(each->slot);
  hits.id = read_int_w(each->id);
  maskw which = s->hit, plain = none_w();
  if (HAS_INSTANCES) which = which & lt_int_w(read_int_w(each->instance), splat_int_w(0));
#define SHAPE(name, planes)                                                        \
  if (LANED(PACKET_BODY_##name) == PACKET_BODY_TRIANGLE)                           \
    plain = plain | LANED(flat_surfaces)(scene, &hits, which, SHAPE_##name, 3, s); \
  else if (LANED(PACKET_BODY_##name) == PACKET_BODY_PARALLELOGRAM)                 \
    plain = plain | LANED(flat_surfaces)(scene, &hits, which, SHAPE_##name, 4, s);
#include "shapes/shapes.def"
#undef SHAPE
  return plain | ~s->hit;
}

FN LANED(Surfaces) LANED(find_surfaces)(const Scene* scene, LANED(Paths) * path, int want, const FirstSample* first) {
  LANED(Surfaces) s = LANED(surfaces_none)();
  LANED(widen)(scene, &path->rays);
  LANED(NearestEach) each = LANED(packet_traverse)(scene, &path->rays, want);
  s.hit = path->alive & ~lt_int_w(read_int_w(each.kind), splat_int_w(0));
  maskw single = path->alive;
  int is_reported = HAS_AOV && first->lane >= 0;
  if (TEXTURE_COUNT == 0 && !is_reported) single = single & ~LANED(plain_surfaces)(scene, &path->rays, &each, &s);
  for (uint lanes = bits_w(single); lanes != 0u; lanes &= lanes - 1u) {
    int lane = first_bit(lanes);
    Ray ray = LANED(ray_of)(&path->rays, lane);
    Nearest nearest = LANED(nearest_of)(&each, lane);
    LANED(take_surface)(scene, path, lane, &ray, &nearest, first, &s);
  }
  return s;
}

FN maskw LANED(meets_any)(const Scene* scene, LANED(Rays) * rays, maskw which) {
  LANED(widen)(scene, rays);
  LANED(NearestEach) each = LANED(packet_traverse)(scene, rays, FIND_ANY);
  return which & ~lt_int_w(read_int_w(each.kind), splat_int_w(0));
}
#endif
