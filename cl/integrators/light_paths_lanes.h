// SPDX-License-Identifier: MIT
// Light paths of integrator ptracer, from the light on. Needs
// integrators/light_begin_lanes.h. One width; no guard.

FN int shows_background_w(const Scene* scene) {
  return LIGHT_COUNT > 0 && scene->index[HEADER_MAX_DEPTH] > 0 && !hides_emitters(scene) &&
         (scene->index[HEADER_BACKGROUND] >= 0 || scene->index[HEADER_SUN] >= 0);
}

/// What the camera sees behind the scene is seen along a ray through a pixel that the path's numbers draw.
FN Joint_w background_joint_w(const Scene* scene, const Paths_w* path, maskw which) {
  PRIVATE const SplatFilm* film = scene->splats;
  Random2_w at = sample_pair_w(scene, &path->sample, USE_SEEN);
  intw columns = int_of_uint_w(high_product_w(at.x, splat_uint_w((uint)film->columns)));
  intw rows = int_of_uint_w(high_product_w(at.y, splat_uint_w((uint)film->rows)));
  Real2_w offset = pixel_offset_w(scene, &path->sample), lens = lens_point_w(scene, &path->sample);
  Joint_w joint;
  joint.is_background = 1;
  joint.stops_at_masks = 0;
  joint.x = real_of_int_w(columns);
  joint.y = real_of_int_w(rows);
  film_rays_w(scene, columns, rows, offset, lens, &joint.rays);
  real3w d = real3_at_w(joint.rays.planes + RAY_PLANE_D);
  joint.light = far_light_w(scene, HEADER_BACKGROUND, d).radiance;
  if (HAS_SUN) joint.light = add3_w(joint.light, far_light_w(scene, HEADER_SUN, d).radiance);
  joint.which = which & not_black_w(joint.light);
  return joint;
}

/// Begins paths as light_paths_leave does, and returns the joints of what the camera sees of the lights.
FN Joint_w light_paths_begin_w(const Scene* scene, Paths_w* path, maskw which, uintw pixels, uintw numbers,
                               Surfaces_w* s) {
  LightChoice_w choice;
  LightRay_w ray = light_paths_leave_w(scene, path, which, pixels, numbers, s, &choice);
  maskw is_shown = path->alive & ray.is_surface;
  if (scene->index[HEADER_MAX_DEPTH] <= 0 || hides_emitters(scene) || !any_w(is_shown)) return no_joint_w();
  SensorWay_w seen = way_to_sensor_w(scene, path, is_shown, ray.from);
  realw cosine = dot3_w(ray.normal, unit3_w(seen.towards));
  return joint_w(s, seen.which & lt_w(splat_w(R(0.0)), cosine), &seen,
                 scale3_w(splat_w(ONE_OVER_PI) * cosine, ray.flux));
}

/// The first vertex of new paths, on their lights, or the next of all that are alive: each is joined with the sensor.
ONCE_FN void follow_light_paths_w(const Scene* scene, Paths_w* path, Branches_w* branches, const NewPaths_w* begun) {
  const FirstSamples none = {0, 0, 0, 0, 0, 0u};
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
