// SPDX-License-Identifier: MIT
// Surfaces that are nothing but boundaries of media: light passes them as it came. They stand apart from what rays meet
// otherwise (scene/scene.h, `met`). So the tree is walked once for the next surface, whatever lies before it, and then
// the boundaries on the way there are met one by one. One width; no guard.

/// The surfaces that the paths' rays meet; called, since paths, shadow rays and boundaries ask for them.
ONCE_FN Surfaces_w meet_surfaces_w(const Scene* scene, Paths_w* path, int want, const FirstSamples* first) {
  return find_surfaces_w(scene, path, want, first);
}

FN FirstSamples no_first_samples_w(void) {
  FirstSamples none;
  none.reals = (GLOBAL real*)0;
  none.ints = (GLOBAL int*)0;
  none.first_pixel = 0;
  none.lanes = 0u;
  return none;
}

/// The medium that a path is in which leaves the surface towards d, and was in `path->medium` before. Its list of
/// shapes with a priority is that beyond. straight: lanes that have passed the surface as they came.
FN intw medium_beyond_w(const Scene* scene, Paths_w* path, const Surfaces_w* s, maskw straight, real3w d) {
  GLOBAL const int* parts = scene->index + media_table(scene)[MEDIA_PARTS];
  maskw is_inside = lt_w(dot3_w(d, s->normal), splat_w(R(0.0)));
  intw at =
      s->part * (int)BOUNDARY_INTS + sel_int_w(is_inside, splat_int_w(BOUNDARY_INSIDE), splat_int_w(BOUNDARY_OUTSIDE));
  intw beyond = gather_int_w(parts, at);
  maskw is_boundary = nonzero_w(beyond - splat_int_w(MEDIUM_SAME)) & ~s->scatters;
  intw medium = sel_int_w(is_boundary, beyond, path->medium);
  if (HAS_PRIORITY) {
    // Those that it reflects are not bent either.
    maskw is_entry = lt_w(s->facing, splat_w(R(0.0))), stays = (is_entry & ~is_inside) | (~is_entry & is_inside);
    straight = (straight | stays) & is_boundary;
    medium = ranked_medium_w(scene, &path->within, s, straight, d, path->medium, medium);
  }
  return medium;
}

/// A ray crosses so many boundaries at most on its way to a surface. Spheres that lie on one another could pass it to
/// and fro by a rounding; more than a few dozen are never in a scene for a purpose.
#define MOST_CROSSINGS 4096

/// A way from boundary to boundary.
typedef struct {
  Paths_w path;    ///< Its rays begin at the last boundary; alive: those that have not come to the end.
  realw end;       ///< t of the surface where each ends, REAL_MAX: none.
  realw reach;     ///< t up to where boundaries matter; REAL_MAX: up to the end.
  intw last;       ///< The part that was entered last; -1: none.
  intw crossed;    ///< How many each has crossed.
  Surfaces_w met;  ///< The boundaries that are next, where
  maskw crosses;   ///< these lanes meet one before their end.
  maskw goes_on;   ///< Lanes whose rays begin before the last boundary.
  maskw is_clear;  ///< Lanes that meet none any more.
  maskw entered;   ///< Lanes that entered a body where they crossed a boundary last.
} Way_w;

/// The paths' way to the surfaces s that their rays meet.
FN Way_w way_of_w(const Paths_w* path, const Surfaces_w* s) {
  Way_w way;
  way.path = *path;
  way.end = sel_w(s->hit, s->t, splat_w(REAL_MAX));
  way.reach = splat_w(REAL_MAX);
  way.last = splat_int_w(-1);
  way.crosses = way.goes_on = way.is_clear = way.entered = none_w();
  way.crossed = splat_int_w(0);
  return way;
}

/// first: lanes whose values beside the picture are stored.
FN void meet_boundaries_w(const Scene* scene, Way_w* way, const FirstSamples* first) {
  int row = media_table(scene)[MEDIA_BOUNDARIES];
  way->crosses = none_w();
  maskw which = way->path.alive & ~way->is_clear & lt_int_w(way->crossed, splat_int_w(MOST_CROSSINGS));
  if (row == 0 || !any_w(which)) return;
  Scene boundaries = *scene;
  boundaries.met = scene->index + row;
  PRIVATE realw* planes = way->path.rays.planes;
  realw most = planes[RAY_PLANE_T_MAX];
  planes[RAY_PLANE_T_MAX] = sel_w(which, min_w(min_w(way->end, most), way->reach), -splat_w(R(1.0)));
  way->met = meet_surfaces_w(&boundaries, &way->path, FIND_NEAREST, first);
  planes[RAY_PLANE_T_MAX] = most;
  way->crosses = which & way->met.hit & lt_w(way->met.t, way->end);
}

/// Lets the lanes of `crosses` come to the other side. A ray that has crossed a flat polygon goes on as it is, from
/// where it met it on: so it meets the polygons of a closed surface in turns, however thin the body within is. From
/// round shapes and boxes it begins anew, exactly, as rays that leave surfaces do (hits/departure.h).
FN void cross_boundaries_w(const Scene* scene, Way_w* way) {
  const Surfaces_w* met = &way->met;
  PRIVATE realw* planes = way->path.rays.planes;
  maskw crosses = way->crosses;
  real3w d = real3_at_w(planes + RAY_PLANE_D);
  realw begin = planes[RAY_PLANE_T_MIN], zero = splat_w(R(0.0));
  maskw enters = lt_w(dot3_w(d, met->normal), zero), is_at_once = le_w(met->t, begin);
  // Where two bodies touch, whichever surface is met first: what has just been entered is not left by the other's.
  maskw is_other = nonzero_w(way->last - met->part) & ~lt_int_w(way->last, splat_int_w(0));
  maskw is_kept = is_at_once & ~enters & is_other;
  if (HAS_PRIORITY) {
    pass_ranked_w(scene, &way->path, met, crosses, d);
    is_kept = is_kept & lt_int_w(part_entry_w(scene, met, PART_RANK), splat_int_w(0));
  }
  intw beyond = medium_beyond_w(scene, &way->path, met, crosses & ~is_kept, d);
  way->path.medium = sel_int_w(crosses & ~is_kept, beyond, way->path.medium);
  way->last = sel_int_w(crosses & enters, met->part, way->last);
  if (media_table(scene)[MEDIA_IS_CONVEX]) way->is_clear = way->is_clear | (crosses & ~enters);
  way->path.entered = sel3_w(crosses, met->position, way->path.entered);

  maskw anew = crosses & ~lt_w(zero, met->bound), goes_on = crosses & ~anew;
  way->goes_on = goes_on;
  realw step = splat_w(REAL_BITS == 64 ? R(0x1p-52) : R(0x1p-23));
  // Two polygons may be met at one t; then the ray goes on beyond it.
  realw next = max_w(fma_w(met->t, step, met->t), splat_w(R(0x1p-100)));
  planes[RAY_PLANE_T_MIN] = sel_w(goes_on, sel_w(is_at_once, next, met->t), begin);
  way->path.rays.departed = sel_int_w(goes_on, met->id, way->path.rays.departed);
  way->path.rays.departed_instance = sel_int_w(goes_on, met->instance, way->path.rays.departed_instance);
  // Nothing is met a second time at one place. Of bodies that lie on one another that is known to a rounding only
  // (tests/render/test_media_edges.cpp).
  realw off = splat_w(REAL_BITS == 64 ? R(0x1p-50) : R(0x1p-21)) *
              largest_of_w(met->position.x, met->position.y, met->position.z);
  maskw is_alike = lt_int_w(splat_int_w(0), way->crossed) & ((enters & way->entered) | ~(enters | way->entered));
  realw least = sel_w(is_at_once, splat_w(R(0x1p-100)), zero);
  least = sel_w(is_alike & le_w(met->t, off), off, least);
  way->crossed = way->crossed + sel_int_w(crosses, splat_int_w(1), splat_int_w(0));
  way->entered = (crosses & enters) | (~crosses & way->entered);
  if (!any_w(anew)) return;
  Rays_w leaving;
  intw aim = way->path.rays.aim;
  rays_leaving_w(met, anew, d, planes[RAY_PLANE_T_MAX] - met->t, &leaving);
  leaving.aim = aim;
  leaving.planes[RAY_PLANE_T_MIN] = sel_w(anew, least, leaving.planes[RAY_PLANE_T_MIN]);
  paths_follow_w(&way->path, anew, &leaving);
  way->end = sel_w(anew & lt_w(way->end, splat_w(REAL_MAX)), way->end - met->t, way->end);
}

/// The flight to the next boundary, to the surfaces s in the lanes of `hit`, or to the way's end.
FN Flight_w flight_along_w(const Way_w* way, const Surfaces_w* s, maskw hit) {
  const Paths_w* path = &way->path;
  Flight_w w;
  real3w d = real3_at_w(path->rays.planes + RAY_PLANE_D), o = real3_at_w(path->rays.planes + RAY_PLANE_O);
  realw size = length3_w(d), zero = splat_w(R(0.0));
  w.d = scale3_w(splat_w(R(1.0)) / size, d);
  w.from = path->entered;
  realw t = sel_w(way->crosses, way->met.t, way->end);
  // Rays begin a little off the surface that they leave.
  realw length = fma_w(t, size, dot3_w(sub3_w(o, path->entered), w.d));
  // Of rays that begin far before their way, places have more digits than t.
  maskw is_between = way->goes_on & (way->crosses | hit);
  real3w at = sel3_w(way->crosses, way->met.position, s->position);
  length = sel_w(is_between, dot3_w(sub3_w(at, path->entered), w.d), length);
  w.length = sel_w(lt_w(t, splat_w(REAL_MAX)), max_w(length, zero), splat_w(REAL_MAX));
  w.optical = path->optical;
  w.throughput = path->throughput;
  w.share = path->hero_shares;
  w.radiance = vec3_w(zero, zero, zero);
  w.scatters = none_w();
  w.t = zero;
  w.draws = path->draws;
  return w;
}
