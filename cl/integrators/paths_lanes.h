// SPDX-License-Identifier: MIT
// The state of paths on their way from surface to surface, one path a lane. One width; no guard.

#include "scene/counters.h"
#if HAS_MEDIA
#include "media/all.h"
#endif
#include "integrators/interfaces_lanes.h"

typedef struct {
  maskw alive;          ///< Paths that go on along `rays`.
  Rays_w rays;          ///< The rays to the next surfaces.
  real3w radiance;      ///< Gathered so far.
  real3w throughput;    ///< Share of the radiance along the ray that reaches the camera.
  real3w from;          ///< The point that the ray has left; undefined where density is 0.
  realw density;        ///< How densely the ray was drawn, per solid angle; 0: no light could have been drawn instead.
  realw eta2;           ///< Square of the index of refraction where the ray runs over that at the camera.
  realw travelled;      ///< Length of the path before the ray; kept only where there are textures.
  intw depth;           ///< Surfaces before the ray: 0 for a camera ray.
  Interfaces_w within;  ///< Kept only where shapes have priorities.
  SampleState_w sample;
#if HAS_MEDIA
  intw medium;         ///< That the ray begins in; below 0: none.
  real3w entered;      ///< Where the ray has left a surface, whether or not it was turned there.
  realw optical;       ///< Optical depth that is left until the path scatters; below 0: not drawn yet.
  real3w hero_shares;  ///< As in media/flight_lanes.h.
  uintw draws;         ///< The next numbers of its stream (samplers/uses.h).
#endif
} Paths_w;

/// No path yet.
FN void paths_none_w(Paths_w* path) {
  realw zero = splat_w(R(0.0));
  path->alive = none_w();
  path->radiance = path->throughput = path->from = vec3_w(zero, zero, zero);
  path->density = path->travelled = zero;
  path->eta2 = splat_w(R(1.0));
  if (HAS_PRIORITY) {
    for (int k = 0; k < INTERFACES_MOST_w; ++k) {
      path->within.rank[k] = path->within.instance[k] = splat_int_w(-1);
      path->within.ior[k] = zero;
    }
  }
  path->depth = path->rays.departed = path->rays.departed_instance = path->rays.aim = splat_int_w(-1);
  path->rays.is_outward = splat_int_w(0);
  path->sample.sample = path->sample.pixel = splat_uint_w(0u);
#if LANES != 1
  for (int k = 0; k < RAY_PLANES; ++k) path->rays.planes[k] = zero;
#endif
#if HAS_MEDIA
  path->medium = splat_int_w(-1);
  for (int k = 0; k < INTERFACES_MOST_w; ++k) path->within.medium[k] = splat_int_w(-1);
  path->within.around = splat_int_w(-1);
  path->entered = path->hero_shares = path->from;
  path->optical = zero;
  path->draws = splat_uint_w(0u);
#endif
}

/// Goes on along those rays in the lanes of `which`.
FN void paths_follow_w(Paths_w* path, maskw which, const Rays_w* rays) {
#if LANES == 1
  // Copied as a whole: an array that a loop runs over stays in memory on PoCL (docs/decisions/0017-once.md).
  if (which) path->rays = *rays;
#else
  for (int k = 0; k < RAY_PLANES; ++k) path->rays.planes[k] = sel_w(which, rays->planes[k], path->rays.planes[k]);
  path->rays.departed = sel_int_w(which, rays->departed, path->rays.departed);
  path->rays.departed_instance = sel_int_w(which, rays->departed_instance, path->rays.departed_instance);
  path->rays.aim = sel_int_w(which, rays->aim, path->rays.aim);
  path->rays.is_outward = sel_int_w(which, rays->is_outward, path->rays.is_outward);
#endif
}

/// Camera rays in the lanes of `which`, instead of paths that have ended.
FN void paths_begin_w(const Scene* scene, Paths_w* path, maskw which, const Rays_w* rays) {
  (void)scene;
  realw one = splat_w(R(1.0)), zero = splat_w(R(0.0));
  path->alive = path->alive | which;
  if (HAS_PRIORITY) interfaces_none_w(which, &path->within);
  paths_follow_w(path, which, rays);
  path->radiance = sel3_w(which, vec3_w(zero, zero, zero), path->radiance);
  path->throughput = sel3_w(which, vec3_w(one, one, one), path->throughput);
  path->density = sel_w(which, zero, path->density);
  path->eta2 = sel_w(which, one, path->eta2);
  path->travelled = sel_w(which, zero, path->travelled);
  path->depth = sel_int_w(which, splat_int_w(0), path->depth);
#if HAS_MEDIA
  real3w d = real3_at_w(rays->planes + RAY_PLANE_D);
  real3w first = fma3_w(rays->planes[RAY_PLANE_T_MIN], d, real3_at_w(rays->planes + RAY_PLANE_O));
  path->entered = sel3_w(which, first, path->entered);
  path->medium = sel_int_w(which, splat_int_w(media_table(scene)[MEDIA_CAMERA]), path->medium);
  if (HAS_PRIORITY) path->within.around = sel_int_w(which, path->medium, path->within.around);
  path->optical = sel_w(which, -one, path->optical);
  path->hero_shares = sel3_w(which, vec3_w(one, one, one), path->hero_shares);
  intw stream = int_of_uint_w(splat_uint_w(STREAM_BEGIN));
  path->draws = uint_of_int_w(sel_int_w(which, stream, int_of_uint_w(path->draws)));
#endif
}

FN void path_add_w(Paths_w* path, maskw which, real3w radiance) {
  path->radiance = sel3_w(which, add3_w(path->radiance, mul3_w(path->throughput, radiance)), path->radiance);
}
