// SPDX-License-Identifier: MIT
// Visibility through media and through surfaces that let light pass as it came: the share of the light that arrives.
// One width; no guard.

/// The surfaces that the paths' rays meet; called, since paths and shadow rays ask for them.
ONCE_FN Surfaces_w meet_surfaces_w(const Scene* scene, Paths_w* path, int want, const FirstSamples* first) {
  return find_surfaces_w(scene, path, want, first);
}

/// The share of light that comes from `towards`, t_max away, to the vertices `from`, in the lanes of `which`. aim: as
/// in Rays.
FN real3w seen_share_w(const Scene* scene, const Paths_w* path, const Surfaces_w* from, maskw which, real3w towards,
                       realw t_max, intw aim) {
  Paths_w way = *path;
  FirstSamples no_first;
  no_first.reals = (GLOBAL real*)0;
  no_first.ints = (GLOBAL int*)0;
  no_first.first_pixel = 0;
  no_first.lanes = 0u;
  realw one = splat_w(R(1.0)), zero = splat_w(R(0.0));
  real3w share = vec3_w(one, one, one);
  way.alive = which;
  way.draws = path->draws + (splat_uint_w(STREAM_SHADOWS) + uint_of_int_w(path->depth) * STREAM_SHADOWS_STEP);
  way.medium = medium_beyond_w(scene, from, towards, path->medium);
  way.entered = from->position;
  rays_leaving_w(from, which, towards, t_max, &way.rays);
  way.rays.aim = aim;
  if (HAS_COUNT_RAYS) count_events(scene, COUNT_SHADOW, lanes_among(bits_w(which)));
  maskw is_far = ~lt_w(t_max, splat_w(REAL_MAX));
  realw left = length3_w(towards);
  while (any_w(way.alive)) {
    Surfaces_w s = meet_surfaces_w(scene, &way, FIND_NEAREST, &no_first);
    real3w d = real3_at_w(way.rays.planes + RAY_PLANE_D);
    maskw hit = way.alive & s.hit, is_within = way.alive & is_within_w(way.medium);
    Flight_w w = flight_of_w(&way, ~hit, s.t);
    w.length = sel_w(hit | is_far, w.length, max_w(left, zero));
    left = left - w.length;
    if (any_w(is_within)) share = mul3_w(share, transmittance_w(scene, way.medium, &way.sample, is_within, &w));
    way.draws = w.draws;
    way.alive = hit;
    if (!any_w(hit)) break;
    s.scatters = none_w();
    MaterialRows_w at = rows_at_w(scene, &s, hit, negate3_w(scale3_w(one / length3_w(d), d)), splat_w(R(0.5)));
    realw open = one - at.opacity;
    share = sel3_w(hit, scale3_w(open, share), share);
    way.alive = hit & lt_w(zero, max3_w(share));
    if (!any_w(way.alive)) break;
    realw rest = way.rays.planes[RAY_PLANE_T_MAX] - s.t;
    media_enter_w(scene, &way, &s, none_w(), d);
    rays_leaving_w(&s, way.alive, d, rest, &way.rays);
    way.rays.aim = aim;
  }
  return share;
}
