// SPDX-License-Identifier: MIT
// Light paths at their beginning: samples of a span, a path each. A path's random numbers belong to its place in one
// sequence of all paths of the picture, or of all that go into one sum, so that Sobol points spread evenly over the
// whole picture's paths: the sequence's number stands in for the pixel, and the place in it for the sample. One width;
// no guard.
#include "light_rays/light_ray_lanes.h"

/// The state of sample `numbers` of pixel `pixels` of the film.
FN SampleState_w light_sample_begin_w(const Scene* scene, uintw pixels, uintw numbers) {
  PRIVATE const SplatFilm* film = scene->splats;
  uint sums = (uint)film->sums;
  uintw sequence = numbers & (sums - 1u);
  uintw place = (numbers / sums) * ((uint)film->columns * (uint)film->rows) + pixels;
  return sequence_begin_w(scene, sequence, place, 1u);
}

FN int shows_background_w(const Scene* scene) {
  return LIGHT_COUNT > 0 && scene->index[HEADER_MAX_DEPTH] > 0 && !hides_emitters(scene) &&
         (scene->index[HEADER_BACKGROUND] >= 0 || scene->index[HEADER_SUN] >= 0);
}

/// What the camera sees behind the scene is seen along a ray through a pixel that the path's numbers draw.
FN Joint_w background_joint_w(const Scene* scene, const Paths_w* path, maskw which) {
  PRIVATE const SplatFilm* film = scene->splats;
  GLOBAL const int* index = scene->index;
  Random2_w at = sample_pair_w(scene, &path->sample, USE_SEEN);
  intw columns = int_of_uint_w(high_product_w(at.x, splat_uint_w((uint)film->columns)));
  intw rows = int_of_uint_w(high_product_w(at.y, splat_uint_w((uint)film->rows)));
  Real2_w offset = pixel_offset_w(scene, &path->sample), lens = lens_point_w(scene, &path->sample);
  Joint_w joint;
  joint.is_background = 1;
  joint.x = real_of_int_w(columns);
  joint.y = real_of_int_w(rows);
  int height = (int)scene->shading[index[HEADER_SENSOR] + SENSOR_HEIGHT];
  camera_rays_w(scene->shading + index[HEADER_CAMERA], index[HEADER_WIDTH], height, columns + splat_int_w(film->x),
                film->y, offset.x, offset.y + joint.y, lens, &joint.rays);
  real3w d = real3_at_w(joint.rays.planes + RAY_PLANE_D);
  joint.light = far_radiance_w(scene, HEADER_BACKGROUND, d);
  if (HAS_SUN) joint.light = add3_w(joint.light, far_radiance_w(scene, HEADER_SUN, d));
  joint.which = which & lt_w(splat_w(R(0.0)), max3_w(joint.light));
  return joint;
}

/// A place on a light as a surface that rays leave.
FN Surfaces_w light_surface_w(const LightRay_w* ray) {
  Surfaces_w s = surfaces_none_w();
  s.position = s.point = ray->from;
  s.normal = s.shading = ray->normal;
  s.bound = ray->bound;
  s.id = splat_int_w(-1);
  return s;
}

/// Begins paths of the given samples in the lanes of `which`; all others end. s: gets the places on lights. Returns the
/// joints of what the camera sees of the lights.
FN Joint_w light_paths_begin_w(const Scene* scene, Paths_w* path, maskw which, uintw pixels, uintw numbers,
                               Surfaces_w* s) {
  realw none = splat_w(R(0.0));
  maskw follows = none_w();
  LightRay_w ray = no_light_ray_w();
  path->sample = light_sample_begin_w(scene, pixels, numbers);
  path->alive = none_w();
  path->depth = splat_int_w(0);
  if (LIGHT_COUNT > 0 && lights_drawn_from(scene) > 0) {
    LightChoice_w choice = choose_light_w(scene, &path->sample, path->depth, vec3_w(none, none, none));
    Random2_w bits = vertex_pair_w(scene, &path->sample, path->depth, USE_WAY);
    Real2_w way;
    way.x = random_between_w(bits.x);
    way.y = random_between_w(bits.y);
    ray = light_ray_w(scene, which, choice.light, light_numbers_w(scene, &path->sample, path->depth), way);
    ray.flux = scale3_w(choice.rarity, ray.flux);
    follows = which & lt_w(none, max3_w(ray.flux));
  }
  *s = light_surface_w(&ray);
  Rays_w rays;
  rays_leaving_w(s, follows, ray.way, splat_w(REAL_MAX), &rays);
  paths_begin_w(scene, path, follows, &rays);
  path->radiance = sel3_w(follows, ray.flux, path->radiance);
  maskw is_shown = follows & ray.is_surface;
  if (scene->index[HEADER_MAX_DEPTH] <= 0 || hides_emitters(scene) || !any_w(is_shown)) return no_joint_w();
  SensorWay_w seen = way_to_sensor_w(scene, path, is_shown, ray.from);
  realw cosine = dot3_w(ray.normal, unit3_w(seen.towards));
  return joint_w(s, seen.which & lt_w(none, cosine), &seen, scale3_w(splat_w(ONE_OVER_PI) * cosine, ray.flux));
}

/// Samples that begin, a lane each.
typedef struct {
  maskw which;
  uintw pixels, numbers;  ///< Of the film, and of the pixel.
} NewPaths_w;

/// The first vertex of new paths, on their lights, or the next of all that are alive: each is joined with the sensor.
ONCE_FN void follow_light_paths_w(const Scene* scene, Paths_w* path, Branches_w* branches, const NewPaths_w* begun) {
  const FirstSamples none = {0, 0, 0, 0u};
  int are_new = any_w(begun->which);
  Surfaces_w s;
  Joint_w joint;
  if (are_new) {
    joint = light_paths_begin_w(scene, path, begun->which, begun->pixels, begun->numbers, &s);
  } else {
    s = find_surfaces_w(scene, path, FIND_NEAREST_APPROXIMATELY, &none);
    joint = ptracer_joint_w(scene, path, &s);
  }
  // One call for all joints, so that a program holds one traversal for them.
  for (int more = are_new && shows_background_w(scene);; more = 0) {
    add_joints_w(scene, path, &joint);
    if (!more) break;
    joint = background_joint_w(scene, path, begun->which);
  }
  if (are_new)
    path->depth = sel_int_w(path->alive, splat_int_w(1), path->depth);
  else
    surface_step_w(scene, path, &s, branches);
}
