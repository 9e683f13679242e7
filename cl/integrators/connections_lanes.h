// SPDX-License-Identifier: MIT
// The techniques of bidirectional path tracing: light that the camera's subpath finds, draws, or gets from the vertices
// of a light's subpath, and what those send to the sensor. Each is weighted among all (integrators/techniques_lanes.h).
// One width; no guard.
#include "integrators/subpaths_lanes.h"

/// The radiance of a light that the camera's rays have found, the one that the header names where nothing is hit. t: as
/// the rays have left the last vertex.
FN void add_found_light_w(const Scene* scene, Paths_w* path, const Surfaces_w* s, int header, FoundLight_w found,
                          const Techniques_w* t) {
  realw zero = splat_w(R(0.0)), one = splat_w(R(1.0));
  real3w radiance = found.radiance;
  maskw is_bright = is_light_shown_w(scene, path) & not_black_w(radiance);
  if (LIGHT_COUNT == 0 || !any_w(is_bright)) {
    path_add_w(path, is_bright, radiance);
    return;
  }
  intw lights = sel_int_w(s->hit, part_entry_w(scene, s, PART_LIGHT), splat_int_w(drawn_afar(scene, header)));
  maskw is_shared = is_bright & lt_int_w(splat_int_w(0), path->depth) & ~lt_int_w(lights, splat_int_w(0));
  if (any_w(is_shared)) {
    real3w ray = real3_at_w(path->rays.planes + RAY_PLANE_D);
    realw drawn = found_density_w(scene, path, s, is_shared, lights, &found);
    realw spread = light_spread_w(scene, is_shared, lights, unit3_w(negate3_w(ray)));
    spread = spread * sel_w(is_long_w(path->depth + splat_int_w(1)), t->ends, t->earlier);
    realw others = fma_w(sel_w(s->hit, one, drawn), spread, sel_w(lt_w(zero, t->last), drawn * t->last, zero));
    realw weight = weight_among_w(others / light_rarity_w(scene, lights, path->from));
    radiance = sel3_w(is_shared, scale3_w(weight, radiance), radiance);
  }
  path_add_w(path, is_bright, radiance);
}

/// The light of one that the vertices of the camera's subpath draw.
FN void add_drawn_light_w(const Scene* scene, Paths_w* path, const Vertex_w* v) {
  if (LIGHT_COUNT == 0 || lights_drawn_from(scene) == 0) return;
  realw zero = splat_w(R(0.0)), one = splat_w(R(1.0)), drawn;
  real3w reflected;
  LightNumbers_w numbers = light_numbers_w(scene, &path->sample, path->depth);
  LightChoice_w choice = choose_light_w(scene, &path->sample, path->depth, v->s.position);
  LightSample_w light = light_sample_w(scene, v->which, choice.light, v->s.position, numbers);
  maskw which = v->which & not_black_w(light.radiance);
  if (HAS_STRICT_NORMALS) which = on_one_side_w(scene, &v->s, which, light.towards);
  if (!any_w(which)) return;
  real3w way = unit3_w(light.towards);
  vertex_share_w(scene, v, which, v->back, way, &reflected, &drawn);
  real3w gain = mul3_w(scale3_w(choice.rarity / light.density, reflected), light.radiance);
  which = which & not_black_w(gain);
  if (!any_w(which)) return;
  Rays_w rays;
  rays_leaving_w(&v->s, which, light.towards, light.t_max, &rays);
  rays.aim = light.aim;
  free_lanes_w(scene, &rays, which, &which);
  if (!any_w(which)) return;
  maskw is_far = ~lt_w(light.t_max, splat_w(REAL_MAX)), is_first = ~lt_int_w(splat_int_w(0), v->depth);
  realw edge = sel_w(light.is_delta, dot3_w(light.towards, light.towards), light.density);
  realw reach = light_spread_w(scene, which, choice.light, negate3_w(way)) * cosine_at_w(v, way);
  reach = reach / sel_w(is_far, one, edge);
  realw reverse = reverse_density_w(scene, v, which, way, v->back);
  realw others = reach * techniques_before_w(&v->t, v->depth + splat_int_w(2), is_first, reverse);
  others = others + sel_w(light.is_delta, zero, drawn * choice.rarity / light.density);
  path_add_w(path, which, scale3_w(weight_among_w(others), gain));
}

/// Rays from x to y that end before its surface. way: unit.
FN Rays_w rays_between_w(const Vertex_w* x, const Vertex_w* y, maskw which, real3w way) {
  Rays_w rays;
  realw t_max = splat_w(R(1.0));
  real3w towards = sub3_w(y->s.position, x->s.position);
#if TIER_FAST
  t_max = t_max - splat_w(FAST_EPSILON) / length3_w(towards);
  (void)way;
#else
  realw bound = max_w(places_rounding_w(y->s.position, x->s.position), abs_w(y->s.bound));
  maskw is_behind = lt_w(splat_w(R(0.0)), dot3_w(way, y->s.normal));
  towards = fma3_w(sel_w(is_behind, -bound, bound), y->s.normal, towards);
#endif
  rays_leaving_w(&x->s, which, towards, t_max, &rays);
  // The fast tier leaves the primitive that is aimed at out, and a round one has a near side that may be in the way.
  maskw is_flat = ~nonzero_w(y->s.is_round), is_aimed = is_flat & lt_int_w(y->s.instance, splat_int_w(0));
  rays.aim = sel_int_w(is_aimed, y->s.id, splat_int_w(-1));
  return rays;
}

/// Of light from `in` to `on` at a vertex of a light's subpath: what leaves it for each unit of area that faces `on`,
/// as adjoint_share of adjoint_lanes.h.
FN real3w leaving_share_w(const Vertex_w* v, real3w on, real3w reflected) {
  realw below = cosine_at_w(v, v->back), zero = splat_w(R(0.0));
  maskw is_sound = lt_w(zero, below);
  realw share = sel_w(is_sound, cosine_at_w(v, on) / sel_w(is_sound, below, splat_w(R(1.0))), zero);
  return scale3_w(share, reflected);
}

/// The light of a vertex of the light's subpath, y, at the camera's, x.
FN void add_connection_w(const Scene* scene, Paths_w* path, const Vertex_w* x, const Vertex_w* y) {
  realw zero = splat_w(R(0.0)), one = splat_w(R(1.0));
  intw edges = x->depth + y->depth + splat_int_w(2), most = splat_int_w(scene->index[HEADER_MAX_DEPTH]);
  maskw which = x->which & y->which & ~is_long_w(edges) & ~lt_int_w(most, edges);
  real3w off = sub3_w(y->s.position, x->s.position), way = unit3_w(off), away = negate3_w(way);
  realw square = dot3_w(off, off);
  which = which & lt_w(zero, square);
  if (HAS_STRICT_NORMALS) which = on_one_side_w(scene, &x->s, on_one_side_w(scene, &y->s, which, away), way);
  if (!any_w(which)) return;
  realw from_x, from_y, to_x, to_y;
  real3w at_x, at_y, unused;
  vertex_share_w(scene, x, which, x->back, way, &at_x, &from_x);
  vertex_share_w(scene, y, which, away, y->back, &at_y, &to_y);
  square = sel_w(which, square, one);
  real3w gain = scale3_w(one / square, mul3_w(mul3_w(at_x, leaving_share_w(y, away, at_y)), y->carried));
  which = which & not_black_w(gain);
  if (!any_w(which)) return;
  Rays_w rays = rays_between_w(x, y, which, way);
  free_lanes_w(scene, &rays, which, &which);
  if (!any_w(which)) return;
  vertex_share_w(scene, x, which, way, x->back, &unused, &to_x);
  vertex_share_w(scene, y, which, y->back, away, &unused, &from_y);
  realw by_camera = from_x * cosine_at_w(y, way) / square, by_light = from_y * cosine_at_w(x, way) / square;
  realw others = by_camera * techniques_before_w(&y->t, edges, none_w(), to_y);
  others = fma_w(by_light, techniques_before_w(&x->t, edges, none_w(), to_x), others);
  path_add_w(path, which, scale3_w(weight_among_w(others), gain));
}

/// What the vertices of a light's subpath send to the sensor. Masks stop it: behind them paths from the camera go on.
FN void join_with_sensor_w(const Scene* scene, const Paths_w* path, const Vertex_w* v) {
  maskw is_shown = v->which;
  if (HAS_EMISSION && hides_emitters(scene))
    is_shown = is_shown & lt_int_w(part_entry_w(scene, &v->s, PART_RADIANCE), splat_int_w(0));
  SensorWay_w way = way_to_sensor_w(scene, path, is_shown, v->s.position);
  if (HAS_STRICT_NORMALS) way.which = on_one_side_w(scene, &v->s, way.which, way.towards);
  if (!any_w(way.which)) return;
  real3w on = unit3_w(way.towards), reflected;
  realw reverse;
  vertex_share_w(scene, v, way.which, on, v->back, &reflected, &reverse);
  maskw is_first = ~lt_int_w(splat_int_w(1), v->depth);
  realw others = techniques_before_w(&v->t, v->depth + splat_int_w(1), is_first, reverse);
  realw weight = weight_among_w(way.gain * cosine_at_w(v, on) * others);
  real3w light = scale3_w(weight, mul3_w(v->carried, leaving_share_w(v, on, reflected)));
  Joint_w joint = joint_w(&v->s, way.which, &way, light);
  joint.stops_at_masks = 1;
  add_joints_w(scene, path, &joint);
}
