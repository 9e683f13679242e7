// SPDX-License-Identifier: MIT
// Vertices of paths within media. A path that scatters before its next surface takes what a surface would be: the place
// stands in the record of the surface that it would have met, marked by `scatters`, so that light is drawn, weighted
// and followed by the same functions there. One width; no guard.

/// The medium that a path is in which leaves the surface towards d; `media`: where the surface is no boundary.
FN intw medium_beyond_w(const Scene* scene, const Surfaces_w* s, real3w d, intw media) {
  GLOBAL const int* parts = scene->index + media_table(scene)[MEDIA_PARTS];
  maskw is_inside = lt_w(dot3_w(d, s->normal), splat_w(R(0.0)));
  intw at =
      s->part * (int)BOUNDARY_INTS + sel_int_w(is_inside, splat_int_w(BOUNDARY_INSIDE), splat_int_w(BOUNDARY_OUTSIDE));
  intw beyond = gather_int_w(parts, at);
  return sel_int_w(nonzero_w(beyond - splat_int_w(MEDIUM_SAME)) & ~s->scatters, beyond, media);
}

/// The way of the rays up to t, in units of their directions, or endless.
FN Flight_w flight_of_w(const Paths_w* path, maskw is_endless, realw t) {
  Flight_w w;
  real3w d = real3_at_w(path->rays.planes + RAY_PLANE_D), o = real3_at_w(path->rays.planes + RAY_PLANE_O);
  realw size = length3_w(d), zero = splat_w(R(0.0));
  w.d = scale3_w(splat_w(R(1.0)) / size, d);
  w.from = path->entered;
  // Rays begin a little off the surface that they leave.
  realw length = fma_w(t, size, dot3_w(sub3_w(o, path->entered), w.d));
  w.length = sel_w(is_endless, splat_w(REAL_MAX), max_w(length, zero));
  w.optical = path->optical;
  w.throughput = path->throughput;
  w.share = path->hero_shares;
  w.radiance = vec3_w(zero, zero, zero);
  w.scatters = none_w();
  w.t = zero;
  w.draws = path->draws;
  return w;
}

/// Lets the paths that are within media go on to the surfaces s that their rays meet, or scatter before them.
FN void media_travel_w(const Scene* scene, Paths_w* path, Surfaces_w* s) {
  maskw which = path->alive & is_within_w(path->medium);
  s->scatters = none_w();
  if (!any_w(which)) return;
  Flight_w w = flight_of_w(path, ~s->hit, s->t);
  maskw is_new = which & lt_w(w.optical, splat_w(R(0.0)));
  if (any_w(is_new)) {
    Random2_w numbers = vertex_pair_w(scene, &path->sample, path->depth, USE_DISTANCE);
    w.optical = sel_w(is_new, optical_depth_w(numbers.x, numbers.y), w.optical);
  }
  travel_w(scene, path->medium, &path->sample, which, &w);
  path->throughput = sel3_w(which, w.throughput, path->throughput);
  path->hero_shares = sel3_w(which, w.share, path->hero_shares);
  path->radiance = sel3_w(which, add3_w(path->radiance, w.radiance), path->radiance);
  path->optical = sel_w(which, w.optical, path->optical);
  path->draws = w.draws;
  s->scatters = which & w.scatters;
  if (!any_w(s->scatters)) return;
  realw zero = splat_w(R(0.0));
  s->hit = s->hit | s->scatters;
  s->position = sel3_w(s->scatters, fma3_w(w.t, w.d, w.from), s->position);
  s->point = sel3_w(s->scatters, s->position, s->point);
  s->normal = sel3_w(s->scatters, w.d, s->normal);
  s->shading = sel3_w(s->scatters, w.d, s->shading);
  s->move = sel3_w(s->scatters, vec3_w(zero, zero, zero), s->move);
  s->bound = sel_w(s->scatters, zero, s->bound);
  // What it does not emit.
  s->facing = sel_w(s->scatters, splat_w(R(1.0)), s->facing);
  s->id = sel_int_w(s->scatters, splat_int_w(-1), s->id);
  s->instance = sel_int_w(s->scatters, splat_int_w(-1), s->instance);
  s->is_round = sel_int_w(s->scatters, splat_int_w(0), s->is_round);
  s->is_flipped = sel_int_w(s->scatters, splat_int_w(0), s->is_flipped);
}

/// As bsdf_eval, of what is there: the surface's material or the medium.
FN real3w vertex_eval_w(const Scene* scene, const Paths_w* path, const Surfaces_w* s, const Bsdf_w* b, real3w wi,
                        PRIVATE realw* density) {
  real3w value = bsdf_eval_w(b, wi, density);
  if (!any_w(s->scatters)) return value;
  realw phase = phase_value_w(scene, path->medium, s->scatters, s->normal, wi);
  *density = sel_w(s->scatters, phase, *density);
  return sel3_w(s->scatters, vec3_w(phase, phase, phase), value);
}

/// Makes those of the lanes that scatter in media draw their way there.
FN void vertex_turn_w(const Scene* scene, const Paths_w* path, const Surfaces_w* s, realw number, realw u, realw v,
                      BsdfSample_w* way) {
  if (!any_w(s->scatters)) return;
  realw density, one = splat_w(R(1.0));
  real3w after = phase_turn_w(scene, path->medium, s->scatters, s->normal, number, u, v, &density);
  way->wi = sel3_w(s->scatters, after, way->wi);
  way->weight = sel3_w(s->scatters, vec3_w(one, one, one), way->weight);
  way->density = sel_w(s->scatters, density, way->density);
  way->eta = sel_w(s->scatters, one, way->eta);
  way->lobe = sel_int_w(s->scatters, splat_int_w(LOBE_GLOSSY | LOBE_REFLECT), way->lobe);
}

/// Lanes of `which` that masks let pass, of integrators for which that is no event: depth and density stay, and lights
/// are drawn through masks as well.
FN maskw passes_openly_w(Paths_w* path, const MaterialRows_w* at, maskw which) {
  which = which & lt_w(at->opacity, splat_w(R(1.0)));
  if (!any_w(which)) return which;
  Random4_w numbers = random4_w(path->sample.pixel, path->sample.sample, path->draws, path->sample.seed);
  path->draws = path->draws + uint_of_int_w(sel_int_w(which, splat_int_w(1), splat_int_w(0)));
  return which & le_w(at->opacity, random_between_w(numbers.x));
}

/// The paths go on from s along d; those of `turned` in a direction that was drawn there.
FN void media_enter_w(const Scene* scene, Paths_w* path, const Surfaces_w* s, maskw turned, real3w d) {
  path->medium = sel_int_w(path->alive, medium_beyond_w(scene, s, d, path->medium), path->medium);
  path->entered = sel3_w(path->alive, s->position, path->entered);
  path->optical = sel_w(turned, splat_w(-R(1.0)), path->optical);
}
