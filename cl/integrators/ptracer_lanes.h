// SPDX-License-Identifier: MIT
// Light tracing: paths begin on lights, are scattered by materials, and from each surface a share of their flux goes to
// the sensor, to whichever pixel sees that place (J. Arvo, "Backward Ray Tracing", SIGGRAPH 1986 course notes; P.
// Dutre, E. Lafortune, Y. Willems, "Monte Carlo Light Tracing with Direct Computation of Pixel Intensities",
// Compugraphics 1993). So it finds caustics of small lights. What the camera sees in mirrors and through glass it does
// not find. path->radiance is the flux with which the path left its light; depth counts as in path, and is 1 on the ray
// from the light.
#include "camera/projection_lanes.h"
#include "film/splat.h"
#include "film/sub_sums.h"

enum { ptracer_STEPS_w = STEP_SCATTER | STEP_ROULETTE | STEP_ADJOINT };

/// Both numbers of a use on the way from the path's vertex to the sensor.
FN Random2_w sensor_pair_w(const Scene* scene, const Paths_w* path, int use) {
  uintw first = uint_of_int_w(path->depth) * (uint)PAIRS_A_SENSOR_WAY;
  return pair_of_set_w(scene, &path->sample, first + (FIRST_OF_SENSOR + ((uint)use >> 1)));
}

FN SensorWay_w way_to_sensor_w(const Scene* scene, const Paths_w* path, maskw which, real3w position) {
  Real2_w lens;
  lens.x = lens.y = splat_w(R(0.0));
  if (HAS_THIN_LENS) {
    Random2_w bits = sensor_pair_w(scene, path, USE_SENSOR_LENS);
    lens = square_to_disk_w(random_between_w(bits.x), random_between_w(bits.y));
  }
  return sensor_way_w(scene, which, position, lens);
}

/// The lanes of `which` that the camera sees. It looks through emitters that are hidden from it.
FN maskw sensor_sees_w(const Scene* scene, const Paths_w* path, const Surfaces_w* s, maskw which,
                       const SensorWay_w* way) {
  if (!HAS_EMISSION || !hides_emitters(scene))
    return sees_along_w(scene, s, which, way->towards, way->t_max, splat_int_w(-1));
  const FirstSamples none = {0, 0, 0, 0u};
  Paths_w ahead = *path;
  Surfaces_w at = *s;
  realw t_max = way->t_max;
  maskw seen = none_w();
  for (ahead.alive = which; any_w(ahead.alive);) {
    rays_leaving_w(&at, ahead.alive, way->towards, t_max, &ahead.rays);
    if (HAS_COUNT_RAYS) count_events(scene, COUNT_SHADOW, lanes_among(bits_w(ahead.alive)));
    // What is left of a ray is in the units of its prepared direction, which is the same for all parts of it.
    at = find_surfaces_w(scene, &ahead, FIND_NEAREST, &none);
    seen = seen | (ahead.alive & ~at.hit);
    ahead.alive = ahead.alive & at.hit & ~lt_int_w(part_entry_w(scene, &at, PART_RADIANCE), splat_int_w(0));
    realw rest = ahead.rays.planes[RAY_PLANE_T_MAX] - at.t;
    t_max = sel_w(ahead.alive, rest * ahead.rays.planes[RAY_PLANE_T_FROM_SCALED], t_max);
  }
  return seen;
}

/// Adds light, before the way's gain, in the lanes of `which` that the camera sees.
FN void send_to_sensor_w(const Scene* scene, const Paths_w* path, const Surfaces_w* s, maskw which,
                         const SensorWay_w* way, real3w light) {
  light = scale3_w(way->gain, light);
  which = which & lt_w(splat_w(R(0.0)), max3_w(light));
  if (!any_w(which)) return;
  which = sensor_sees_w(scene, path, s, which, way);
  Random2_w bits = sensor_pair_w(scene, path, USE_SENSOR_PIXEL);
  realw u = random_between_w(bits.x), v = random_between_w(bits.y);
  for (uint lanes = bits_w(which); lanes != 0u; lanes &= lanes - 1u) {
    int i = first_bit(lanes);
    // Paths of a sum are a sequence of their own, with its number as their pixel.
    int sum = get_int_w((PRIVATE const intw*)&path->sample.pixel, i);
    splat_place(scene, get_w(&way->x, i), get_w(&way->y, i), get_w(&u, i), get_w(&v, i), sum, get3_w(&light, i));
  }
}

/// The share of light that the surfaces send to the sensor, per unit of area that faces it. The material is evaluated as
/// by a path from the camera, so that nothing of it need be symmetric.
FN real3w shown_light_w(const Scene* scene, const Paths_w* path, const Surfaces_w* s, maskw which,
                        const SensorWay_w* way) {
  real3w out = unit3_w(way->towards), in = unit3_w(negate3_w(real3_at_w(path->rays.planes + RAY_PLANE_D)));
  realw number = splat_w(R(0.0)), zero = number, one = splat_w(R(1.0)), density;
  if (HAS_BLEND) number = random_between_w(vertex_number_w(scene, &path->sample, path->depth, USE_BLEND));
  MaterialRows_w at = rows_at_w(scene, s, which, out, number);
  Bsdf_w b = bsdf_at_w(scene, s, &at, out);
  if (HAS_PRIORITY) {
    Crossing_w crossing = crossing_of_w(scene, &path->within, s, which, &b);
    which = which & ~(crossing.which & ~crossing.is_real);
  }
  real3w light = mul3_w(mul3_w(path->radiance, path->throughput), bsdf_eval_w(&b, in, &density));
  // bsdf_eval has |in.ns|, flux has |in.ng|.
  realw below = abs_w(dot3_w(in, s->normal)), above = abs_w(dot3_w(out, s->normal));
  maskw is_sound = which & lt_w(zero, below);
  realw share = above / sel_w(is_sound, below, one);
  if (HAS_MASK) share = share * at.opacity;
  return sel3_w(is_sound, scale3_w(share, light), vec3_w(zero, zero, zero));
}

FN maskw ptracer_step_w(const Scene* scene, Paths_w* path, const Surfaces_w* s, PRIVATE int* next) {
  intw most = splat_int_w(scene->index[HEADER_MAX_DEPTH]);
  *next = ptracer_STEPS_w;
  maskw on = path->alive & s->hit & lt_int_w(path->depth, most);
  SensorWay_w way = way_to_sensor_w(scene, path, on, s->position);
  if (any_w(way.which)) send_to_sensor_w(scene, path, s, way.which, &way, shown_light_w(scene, path, s, way.which, &way));
  return on & lt_int_w(path->depth, most - splat_int_w(1));
}
