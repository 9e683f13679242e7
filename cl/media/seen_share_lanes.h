// SPDX-License-Identifier: MIT
// Visibility through media and through surfaces that let light pass as it came: the share of the light that arrives.
// One width; no guard.
#if HAS_PANE
#include "media/panes_lanes.h"
#endif

/// What the media between the lanes' rays and their ends let through; s: the surfaces there, in the lanes of `hit`.
/// open: where ways without an end begin, and how much of them counts.
FN real3w way_share_w(const Scene* scene, Way_w* way, const Surfaces_w* s, maskw hit, const OpenWay_w* open) {
  FirstSamples none = no_first_samples_w();
  realw one = splat_w(R(1.0));
  real3w share = vec3_w(one, one, one);
  for (;;) {
    meet_boundaries_w(scene, way, &none);
    maskw which = way->path.alive & is_within_w(way->path.medium);
    if (any_w(which)) {
      Flight_w w = flight_along_w(way, s, hit);
      if (HAS_OPEN_MEDIA) end_flight_w(open, &w);
      share = mul3_w(share, transmittance_w(scene, way->path.medium, &way->path.sample, which, &w));
      way->path.draws = w.draws;
    }
    way->path.alive = way->crosses & lt_w(splat_w(R(0.0)), max3_w(share));
    way->crosses = way->path.alive;
    if (!any_w(way->path.alive)) return share;
    cross_boundaries_w(scene, way);
  }
}

/// The share of light that comes from `towards`, t_max away, to the vertices `from`, in the lanes of `which`. aim: as
/// in Rays.
FN real3w seen_share_w(const Scene* scene, const Paths_w* path, const Surfaces_w* from, maskw which, real3w towards,
                       realw t_max, intw aim) {
  FirstSamples none = no_first_samples_w();
  Surfaces_w s = surfaces_none_w();
  Way_w way = way_of_w(path, &s);
  realw one = splat_w(R(1.0)), zero = splat_w(R(0.0)), most = splat_w(REAL_MAX);
  real3w share = vec3_w(one, one, one);
  way.path.draws = path->draws + (splat_uint_w(STREAM_SHADOWS) + uint_of_int_w(path->depth) * STREAM_SHADOWS_STEP);
  if (HAS_PRIORITY) pass_ranked_w(scene, &way.path, from, which, towards);
  way.path.medium = medium_beyond_w(scene, &way.path, from, none_w(), towards);
  way.path.entered = from->position;
  rays_leaving_w(from, which, towards, t_max, &way.path.rays);
  way.path.rays.aim = aim;
  if (HAS_COUNT_RAYS) count_events(scene, COUNT_SHADOW, lanes_among(bits_w(which)));
  maskw is_far = ~lt_w(t_max, most), ahead = which;
  OpenWay_w open = open_way_w(scene, from->position);
  int has_veils = media_table(scene)[MEDIA_VEILS];
  if (!has_veils) {
    // Whatever is met ends the ray.
    ahead = ahead & ~meets_any_w(scene, &way.path.rays, ahead);
    share = sel3_w(ahead, share, vec3_w(zero, zero, zero));
  }
  while (any_w(ahead)) {
    way.path.alive = ahead;
    if (has_veils) s = meet_surfaces_w(scene, &way.path, FIND_NEAREST, &none);
    maskw hit = ahead & s.hit;
    real3w d = real3_at_w(way.path.rays.planes + RAY_PLANE_D);
    realw last = way.path.rays.planes[RAY_PLANE_T_MAX];
    way.end = sel_w(hit, s.t, sel_w(is_far, most, last));
    way.last = splat_int_w(-1);
    way.goes_on = way.is_clear = none_w();
    share = mul3_w(share, way_share_w(scene, &way, &s, hit, &open));
    if (!any_w(hit)) break;
    s.scatters = none_w();
    real3w out = negate3_w(scale3_w(one / length3_w(d), d));
    realw number = splat_w(R(0.5));
    // Which part of a blend is met decides whether it is a pane, and how open it is.
    int has_open_parts = HAS_PANE;
    if (HAS_MASK) has_open_parts = 1;
    if (has_open_parts && HAS_BLEND)
      number = random_between_w(stream_numbers_w(&way.path.sample, hit, &way.path.draws).x);
    MaterialRows_w at = rows_at_w(scene, &s, hit, out, number);
    realw open = one - at.opacity;
    real3w lets = vec3_w(open, open, open);
#if HAS_PANE
    Pane_w pane = pane_at_w(scene, &way.path.within, &s, &at, hit, out);
    lets = add3_w(lets, scale3_w(at.opacity * pane.through, pane.tint));
#endif
    share = sel3_w(hit, mul3_w(lets, share), share);
    ahead = way.path.alive = hit & lt_w(zero, max3_w(share));
    if (!any_w(ahead)) break;
    if (HAS_PRIORITY) pass_ranked_w(scene, &way.path, &s, ahead, d);
    media_enter_w(scene, &way.path, &s, none_w(), d);
    rays_passing_w(&s, ahead, ahead, d, last - s.t, &way.path.rays);
    way.path.rays.aim = aim;
  }
  return share;
}
