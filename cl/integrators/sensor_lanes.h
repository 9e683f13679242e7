// SPDX-License-Identifier: MIT
// Connections of light paths to the sensor: the place on the lens that a vertex is joined with, and what arrives there
// is added to whichever pixel sees the vertex. One width; no guard.
#include "camera/projection_lanes.h"
#include "film/splat.h"
#include "film/sub_sums.h"
#include "integrators/sensor_share_lanes.h"

/// Splats of a path are numbered: the background, then the light itself and each surface, by their depth.
enum { SPLAT_OF_BACKGROUND_w = 1, SPLATS_BEFORE_SURFACES_w = 2 };

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
                SPLATS_BEFORE_SURFACES_w + get_int_w(&path->depth, i), get3_w(&light, i));
  }
}
