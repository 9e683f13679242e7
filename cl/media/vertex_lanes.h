// SPDX-License-Identifier: MIT
// Vertices of paths within media. A path that scatters before its next surface takes what a surface would be: the place
// stands in the record of the surface that it would have met, marked by `scatters`, so that light is drawn, weighted
// and followed by the same functions there. One width; no guard.

/// Puts the places where the lanes of `which` scatter into the records of the surfaces that they would have met.
FN void scatter_before_w(Surfaces_w* s, maskw which, const Flight_w* w) {
  s->scatters = s->scatters | which;
  realw zero = splat_w(R(0.0));
  s->hit = s->hit | which;
  s->position = sel3_w(which, fma3_w(w->t, w->d, w->from), s->position);
  s->point = sel3_w(which, s->position, s->point);
  s->normal = sel3_w(which, w->d, s->normal);
  s->shading = sel3_w(which, w->d, s->shading);
  s->move = sel3_w(which, vec3_w(zero, zero, zero), s->move);
  s->bound = sel_w(which, zero, s->bound);
  // What it does not emit.
  s->facing = sel_w(which, splat_w(R(1.0)), s->facing);
  s->id = sel_int_w(which, splat_int_w(-1), s->id);
  s->instance = sel_int_w(which, splat_int_w(-1), s->instance);
  s->is_round = sel_int_w(which, splat_int_w(0), s->is_round);
  s->is_flipped = sel_int_w(which, splat_int_w(0), s->is_flipped);
}

/// The surfaces that the rays of `which` meet at last, into s.
FN void see_on_w(const Scene* scene, Paths_w* path, maskw which, Surfaces_w* s) {
  FirstSamples none = no_first_samples_w();
  maskw alive = path->alive;
  realw t_max = path->rays.planes[RAY_PLANE_T_MAX];
  path->alive = which;
  Surfaces_w met = meet_surfaces_w(scene, path, FIND_NEAREST, &none);
  path->alive = alive;
  path->rays.planes[RAY_PLANE_T_MAX] = t_max;
  sel_surfaces_w(which, &met, s);
}

/// Lets the paths go on to the surfaces s that their rays meet, or scatter in a medium before them. outlook: that the
/// surfaces were looked for with.
FN void media_travel_w(const Scene* scene, Paths_w* path, const Outlook_w* outlook, Surfaces_w* s) {
  maskw cut = outlook->cut & ~s->hit;
  path->rays.planes[RAY_PLANE_T_MAX] = outlook->t_max;
  s->scatters = none_w();
  // No path has a first way then, as in Mitsuba.
  if (scene->index[HEADER_MAX_DEPTH] == 0) return;
  if (media_table(scene)[MEDIA_BOUNDARIES] == 0 && !any_w(path->alive & is_within_w(path->medium))) return;
  FirstSamples none = no_first_samples_w();
  Way_w way = way_of_w(path, s);
  way.reach = outlook->reach;
  Flight_w w;
  for (;;) {
    meet_boundaries_w(scene, &way, &none);
    maskw which = way.path.alive & is_within_w(way.path.medium);
    maskw scatters = none_w();
    if (any_w(which)) {
      w = flight_along_w(&way, s, s->hit);
      travel_w(scene, way.path.medium, &path->sample, which, &w);
      path->throughput = way.path.throughput = sel3_w(which, w.throughput, path->throughput);
      path->hero_shares = way.path.hero_shares = sel3_w(which, w.share, path->hero_shares);
      path->radiance = sel3_w(which, add3_w(path->radiance, w.radiance), path->radiance);
      path->optical = way.path.optical = sel_w(which, w.optical, path->optical);
      path->draws = way.path.draws = w.draws;
      scatters = which & w.scatters;
    }
    // These leave their medium before they would have scattered.
    cut = cut & ~scatters;
    if (any_w(cut)) {
      see_on_w(scene, path, cut, s);
      way.end = sel_w(cut & s->hit, s->t, way.end);
      cut = none_w();
    }
    if (any_w(scatters)) {
      scatter_before_w(s, scatters, &w);
      realw way_here = length3_w(sub3_w(s->position, real3_at_w(path->rays.planes + RAY_PLANE_O)));
      if (TEXTURE_COUNT > 0) path->travelled = sel_w(scatters, outlook->travelled + way_here, path->travelled);
    }
    path->medium = sel_int_w(way.path.alive, way.path.medium, path->medium);
    if (HAS_PRIORITY) sel_interfaces_w(way.path.alive, &way.path.within, &path->within);
    way.path.alive = way.crosses & ~scatters;
    if (!any_w(way.path.alive)) break;
    way.crosses = way.path.alive;
    cross_boundaries_w(scene, &way);
    way.reach = scatter_reach_w(scene, &way.path);
  }
}

/// Lanes that scatter in a medium in which no lights are drawn.
FN maskw are_unlit_w(const Scene* scene, const Paths_w* path, const Surfaces_w* s) {
  if (!HAS_UNLIT_MEDIA || !any_w(s->scatters)) return none_w();
  intw medium = sel_int_w(s->scatters, path->medium, splat_int_w(0));
  GLOBAL const int* is_lit = medium_row(scene, 0) + MEDIUM_IS_LIT;
  return s->scatters & ~nonzero_w(gather_int_w(is_lit, medium * splat_int_w(MEDIUM_INTS)));
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

/// Makes those of the lanes that scatter in media draw their way there. Where no lights are drawn the density is 0, as
/// of a delta lobe: what the way finds has no other technique.
FN void vertex_turn_w(const Scene* scene, const Paths_w* path, const Surfaces_w* s, realw number, realw u, realw v,
                      BsdfSample_w* way) {
  if (!any_w(s->scatters)) return;
  realw density, one = splat_w(R(1.0));
  real3w after = phase_turn_w(scene, path->medium, s->scatters, s->normal, number, u, v, &density);
  way->wi = sel3_w(s->scatters, after, way->wi);
  way->weight = sel3_w(s->scatters, vec3_w(one, one, one), way->weight);
  way->density = sel_w(s->scatters, density, way->density);
  if (HAS_UNLIT_MEDIA) way->density = sel_w(are_unlit_w(scene, path, s), splat_w(R(0.0)), way->density);
  way->eta = sel_w(s->scatters, one, way->eta);
  way->lobe = sel_int_w(s->scatters, splat_int_w(LOBE_GLOSSY | LOBE_REFLECT), way->lobe);
}

/// Lanes of `which` that masks let pass, of integrators for which that is no event: depth and density stay, and lights
/// are drawn through masks as well.
FN maskw passes_openly_w(Paths_w* path, const MaterialRows_w* at, maskw which) {
  which = which & lt_w(at->opacity, splat_w(R(1.0)));
  if (!any_w(which)) return which;
  Random4_w numbers = stream_numbers_w(&path->sample, which, &path->draws);
  return which & le_w(at->opacity, random_between_w(numbers.x));
}

/// The paths go on from s along d; those of `turned` in a direction that was drawn there.
FN void media_enter_w(const Scene* scene, Paths_w* path, const Surfaces_w* s, maskw turned, real3w d) {
  path->medium = sel_int_w(path->alive, medium_beyond_w(scene, path, s, ~turned, d), path->medium);
  path->entered = sel3_w(path->alive, s->position, path->entered);
  path->optical = sel_w(turned, splat_w(-R(1.0)), path->optical);
}
