// SPDX-License-Identifier: MIT
// Light tracing: paths begin on lights, are scattered by materials, and from each surface a share of their flux goes to
// the sensor, to whichever pixel sees that place (J. Arvo, "Backward Ray Tracing", SIGGRAPH 1986 course notes; P.
// Dutre, E. Lafortune, Y. Willems, "Monte Carlo Light Tracing with Direct Computation of Pixel Intensities",
// Compugraphics 1993). So it finds caustics of small lights. What the camera sees in mirrors and through glass it does
// not find. path->radiance is the flux with which the path left its light; depth counts as in path, and is 1 on the ray
// from the light.

enum { ptracer_STEPS_w = STEP_SCATTER | STEP_ROULETTE | STEP_ADJOINT };

/// The share of light that the surfaces send to the sensor, per unit of area that faces it.
FN real3w shown_light_w(const Scene* scene, const Paths_w* path, const Surfaces_w* s, maskw which,
                        const SensorWay_w* way) {
  realw opacity;
  real3w in = unit3_w(negate3_w(real3_at_w(path->rays.planes + RAY_PLANE_D)));
  real3w share = adjoint_share_w(scene, path, s, which, in, unit3_w(way->towards), &opacity);
  if (HAS_MASK) share = scale3_w(opacity, share);
  return mul3_w(mul3_w(path->radiance, path->throughput), share);
}

/// Lanes in which strict_normals lets light come along the rays of `path` and leave for the sensor.
FN maskw shown_on_one_side_w(const Scene* scene, const Paths_w* path, const Surfaces_w* s, maskw which,
                             const SensorWay_w* way) {
  which = on_one_side_w(scene, s, which, negate3_w(real3_at_w(path->rays.planes + RAY_PLANE_D)));
  return on_one_side_w(scene, s, which, way->towards);
}

/// The joints of the surfaces that the rays of `path` have met.
FN Joint_w ptracer_joint_w(const Scene* scene, const Paths_w* path, const Surfaces_w* s) {
  maskw is_shown = path->alive & s->hit & lt_int_w(path->depth, splat_int_w(scene->index[HEADER_MAX_DEPTH]));
  if (HAS_EMISSION && hides_emitters(scene))
    is_shown = is_shown & lt_int_w(part_entry_w(scene, s, PART_RADIANCE), splat_int_w(0));
  SensorWay_w way = way_to_sensor_w(scene, path, is_shown, s->position);
  if (HAS_STRICT_NORMALS) way.which = shown_on_one_side_w(scene, path, s, way.which, &way);
  if (!any_w(way.which)) return no_joint_w();
  return joint_w(s, way.which, &way, shown_light_w(scene, path, s, way.which, &way));
}

FN maskw ptracer_step_w(const Scene* scene, Paths_w* path, const Surfaces_w* s, PRIVATE int* next) {
  *next = ptracer_STEPS_w;
  return path->alive & s->hit & lt_int_w(path->depth, splat_int_w(scene->index[HEADER_MAX_DEPTH] - 1));
}
