// SPDX-License-Identifier: MIT
// What a specialised program is held against: spheres that glow, seen through the pixels' middles, and nothing else.
// One work-item a pixel; no tree, no lists of kinds, no parts, no dispatch. `lanes` tests blocks of spheres by strahl's
// own body, so that its picture is strahl's bit for bit in every tier; `scalar` is the textbook's loop, one sphere
// after the other, which a compiler may run over work-items in lanes.
#include "math/vec3.h"
#include "lanes/lane_ops.h"
#include "accel/packet_kinds.h"
#include "hits/candidates.h"
#include "film/film.h"
#include "rays/ray.h"
#include "scene/scene.h"
#include "shapes/ball.h"
#include "shapes/polygon/edge_lanes.h"
#if TIER_ROBUST
#include "shapes/exact/exact_scalar.h"
#endif
#if !(TIER_ROBUST && LANES == 1)
#include "accel/slabs_lanes.h"
#endif
#include "shapes/sphere/sphere_lanes.h"
#if TIER_ROBUST
#include "shapes/exact/settle_kinds.h"
#endif

/// camera_rays of camera/camera_lanes.h for one ray through the pixel's middle.
FN Ray ray_through(GLOBAL const real* camera, int width, int height, int x, int y) {
  real sx = (real)(2 * x + 1 - width) / (real)width, sy = (real)(2 * y + 1 - height) / (real)height;
  real3 o = fma3(sy, load3(camera + CAMERA_OY), fma3(sx, load3(camera + CAMERA_OX), load3(camera + CAMERA_O)));
  real3 d = fma3(sy, load3(camera + CAMERA_DY), fma3(sx, load3(camera + CAMERA_DX), load3(camera + CAMERA_D)));
  return ray_make(o, d, camera[CAMERA_NEAR], camera[CAMERA_FAR], -1);
}

/// radiance: three reals a sphere, in the order of their ids; neither NaN nor infinite.
FN void expose(GLOBAL long* sums, GLOBAL const real* radiance, int id) {
  for (int k = 0; k < FILM_CHANNELS; ++k) film_add(sums + k * FILM_SUM_WORDS, film_bins_of(radiance[3 * id + k]));
}

KERNEL LANE_HINT void lanes(GLOBAL const real* camera, GLOBAL const real* spheres, GLOBAL const int* ids,
                            GLOBAL const real* radiance, GLOBAL long* film, int width, int height, int blocks) {
  int x = (int)get_global_id(0), y = (int)get_global_id(1);
  if (x >= width || y >= height) return;
  Ray ray = ray_through(camera, width, height, x, y);
  Nearest best = nearest_none(ray.t_max);
  for (int b = 0; b < blocks; ++b) sphere_block_w(&ray, spheres + b * 4 * LANES, ids + b * LANES, b * LANES, &best);
#if TIER_ROBUST
  nearest_settle(&ray, &best, LANES);
#endif
  if (best.kind < 0) return;
  GLOBAL const real* sphere = spheres + best.slot / LANES * 4 * LANES + best.slot % LANES;
  real3 out = sub3(fma3(best.t, ray.d, ray.o), vec3(sphere[0], sphere[LANES], sphere[2 * LANES]));
  if (dot3(out, ray.d) < R(0.0))
    expose(film + ((ulong)y * (ulong)width + (ulong)x) * (FILM_CHANNELS * FILM_SUM_WORDS), radiance, best.id);
}

KERNEL void scalar(GLOBAL const real* camera, GLOBAL const real* spheres, GLOBAL const int* ids,
                   GLOBAL const real* radiance, GLOBAL long* film, int width, int height, int blocks) {
  int x = (int)get_global_id(0), y = (int)get_global_id(1);
  if (x >= width || y >= height) return;
  Ray ray = ray_through(camera, width, height, x, y);
  real a = dot3(ray.d, ray.d), nearest = ray.t_max;
  int hit = -1;
  for (int i = 0; i < blocks * LANES; ++i) {
    GLOBAL const real* sphere = spheres + i / LANES * 4 * LANES + i % LANES;
    real3 f = sub3(ray.o, vec3(sphere[0], sphere[LANES], sphere[2 * LANES]));
    real radius = sphere[3 * LANES], b = dot3(f, ray.d);
    real discriminant = b * b - a * (dot3(f, f) - radius * radius);
    real t = (-b - real_sqrt(discriminant)) / a;
    if (ids[i] >= 0 && discriminant >= R(0.0) && t >= ray.t_min && t < nearest) {
      nearest = t;
      hit = ids[i];
    }
  }
  if (hit >= 0) expose(film + ((ulong)y * (ulong)width + (ulong)x) * (FILM_CHANNELS * FILM_SUM_WORDS), radiance, hit);
}
