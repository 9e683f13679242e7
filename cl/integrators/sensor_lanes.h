// SPDX-License-Identifier: MIT
// Joints of light paths with the sensor: the place on the lens that a vertex is joined with, and what arrives there is
// added to whichever pixel sees the vertex. What the camera sees behind the scene is a joint too, from the sensor
// outwards. One width; no guard.
#include "camera/projection_lanes.h"
#include "film/splat.h"
#include "film/sub_sums.h"
#include "integrators/seen_through_lanes.h"

typedef struct {
  maskw which;
  Rays_w rays;         ///< Along which nothing may be in the way.
  real3w light;        ///< What is then added.
  realw x, y;          ///< Where on the picture, in pixels from its upper left corner.
  int stops_at_masks;  ///< Masks let nothing through.
  int is_background;   ///< Then the light is a pixel's own, x and y its column and row on the film.
} Joint_w;

FN Joint_w no_joint_w(void) {
  Joint_w joint;
  joint.which = none_w();
  joint.is_background = joint.stops_at_masks = 0;
  return joint;
}

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

/// Of the vertices at s. light: what leaves them for the sensor, per unit of area that faces it.
FN Joint_w joint_w(const Surfaces_w* s, maskw which, const SensorWay_w* way, real3w light) {
  Joint_w joint;
  joint.light = scale3_w(way->gain, light);
  joint.which = which & not_black_w(joint.light);
  joint.x = way->x;
  joint.y = way->y;
  joint.is_background = joint.stops_at_masks = 0;
  rays_leaving_w(s, joint.which, way->towards, way->t_max, &joint.rays);
  return joint;
}

/// Traces the joints, and adds what arrives to the film. A path's sum is the number of its sequence, which stands in
/// for the pixel. Splats of a path are counted in their order: the light itself, the background, each surface by its
/// depth.
FN void add_joints_w(const Scene* scene, const Paths_w* path, Joint_w* joint) {
  if (!any_w(joint->which)) return;
  realw share = unhindered_share_w(scene, path, joint->which, joint->stops_at_masks, &joint->rays);
  real3w light = scale3_w(share, joint->light);
  Random2_w bits = sensor_pair_w(scene, path, USE_SENSOR_PIXEL);
  realw u = random_between_w(bits.x), v = random_between_w(bits.y);
  for (uint lanes = bits_w(joint->which & lt_w(splat_w(R(0.0)), share)); lanes != 0u; lanes &= lanes - 1u) {
    int i = first_bit(lanes), sum = get_int_w((PRIVATE const intw*)&path->sample.pixel, i);
    int depth = get_int_w(&path->depth, i);
    real x = get_w(&joint->x, i), y = get_w(&joint->y, i);
    if (joint->is_background)
      splat_pixel(scene, (int)x, (int)y, sum, 2, get3_w(&light, i));
    else
      splat_place(scene, x, y, get_w(&u, i), get_w(&v, i), sum, depth == 0 ? 1 : depth + 2, get3_w(&light, i));
  }
}
