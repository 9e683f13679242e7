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
#include "integrators/sensor_share_lanes.h"

/// Splats of a path are numbered: the background, then the light itself and each surface, by their depth.
enum { SPLAT_OF_BACKGROUND = 1, SPLATS_BEFORE_SURFACES = 2 };
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

/// Adds light, before the way's gain, in the lanes of `which` that the camera sees.
FN void send_to_sensor_w(const Scene* scene, const Paths_w* path, const Surfaces_w* s, maskw which,
                         const SensorWay_w* way, real3w light) {
  light = scale3_w(way->gain, light);
  which = which & lt_w(splat_w(R(0.0)), max3_w(light));
  if (!any_w(which)) return;
  realw share = sensor_share_w(scene, path, s, which, way->towards, way->t_max);
  which = which & lt_w(splat_w(R(0.0)), share);
  light = scale3_w(share, light);
  Random2_w bits = sensor_pair_w(scene, path, USE_SENSOR_PIXEL);
  realw u = random_between_w(bits.x), v = random_between_w(bits.y);
  for (uint lanes = bits_w(which); lanes != 0u; lanes &= lanes - 1u) {
    int i = first_bit(lanes);
    // Paths of a sum are a sequence of their own, with its number as their pixel.
    int sum = get_int_w((PRIVATE const intw*)&path->sample.pixel, i);
    splat_place(scene, get_w(&way->x, i), get_w(&way->y, i), get_w(&u, i), get_w(&v, i), sum,
                SPLATS_BEFORE_SURFACES + get_int_w(&path->depth, i), get3_w(&light, i));
  }
}

/// The share of light that the surfaces send to the sensor, per unit of area that faces it.
FN real3w shown_light_w(const Scene* scene, const Paths_w* path, const Surfaces_w* s, maskw which,
                        const SensorWay_w* way) {
  realw opacity;
  real3w in = unit3_w(negate3_w(real3_at_w(path->rays.planes + RAY_PLANE_D)));
  real3w share = adjoint_share_w(scene, path, s, which, in, unit3_w(way->towards), &opacity);
  if (HAS_MASK) share = scale3_w(opacity, share);
  return mul3_w(mul3_w(path->radiance, path->throughput), share);
}

FN maskw ptracer_step_w(const Scene* scene, Paths_w* path, const Surfaces_w* s, PRIVATE int* next) {
  intw most = splat_int_w(scene->index[HEADER_MAX_DEPTH]);
  *next = ptracer_STEPS_w;
  maskw on = path->alive & s->hit & lt_int_w(path->depth, most);
  maskw is_shown = on;
  if (HAS_EMISSION && hides_emitters(scene))
    is_shown = on & lt_int_w(part_entry_w(scene, s, PART_RADIANCE), splat_int_w(0));
  SensorWay_w way = way_to_sensor_w(scene, path, is_shown, s->position);
  if (any_w(way.which)) {
    real3w light = shown_light_w(scene, path, s, way.which, &way);
    send_to_sensor_w(scene, path, s, way.which, &way, light);
  }
  return on & lt_int_w(path->depth, most - splat_int_w(1));
}
