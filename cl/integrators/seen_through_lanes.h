// SPDX-License-Identifier: MIT
// Visibility from the camera, for light paths: emitters that are hidden from it are ignored, and masks let the share of
// light through that their opacity leaves. A mask counts as a surface of the path. One width; no guard.

/// What is left of light along the rays of `ahead`, in the lanes that are alive there. The masks that it meets add to
/// its depth.
FN realw passed_share_w(const Scene* scene, Paths_w* ahead, int stops_at_masks) {
  const FirstSamples none = {0, 0, 0, 0, 0, 0u};
  real3w d = real3_at_w(ahead->rays.planes + RAY_PLANE_D);
  intw most = splat_int_w(scene->index[HEADER_MAX_DEPTH]);
  realw zero = splat_w(R(0.0)), one = splat_w(R(1.0)), share = sel_w(ahead->alive, one, zero);
  for (;;) {
    if (HAS_COUNT_RAYS) count_events(scene, COUNT_SHADOW, lanes_among(bits_w(ahead->alive)));
    Surfaces_w s = find_surfaces_w(scene, ahead, FIND_NEAREST, &none);
    maskw met = ahead->alive & s.hit, passed = none_w();
    if (!any_w(met)) return share;
    if (HAS_EMISSION && hides_emitters(scene))
      passed = met & ~lt_int_w(part_entry_w(scene, &s, PART_RADIANCE), splat_int_w(0));
    maskw masked = met & ~passed;
    if (HAS_MASK && !stops_at_masks && any_w(masked)) {
      realw number = zero;
      // Before a number is drawn: those of the vertex that the rays leave are taken.
      ahead->depth = sel_int_w(masked, ahead->depth + splat_int_w(1), ahead->depth);
      if (HAS_BLEND) number = random_between_w(vertex_number_w(scene, &ahead->sample, ahead->depth, USE_BLEND));
      realw open = one - rows_at_w(scene, &s, masked, unit3_w(negate3_w(d)), number).opacity;
      maskw lets = masked & lt_w(zero, open) & lt_int_w(ahead->depth, most);
      share = sel_w(lets, share * open, share);
      passed = passed | lets;
    }
    share = sel_w(met & ~passed, zero, share);
    if (!any_w(passed)) return share;
    rays_passing_w(&s, passed, passed, d, ahead->rays.planes[RAY_PLANE_T_MAX] - s.t, &ahead->rays);
    ahead->alive = passed;
  }
}

/// 1: something may be seen through.
FN int is_seen_through_w(const Scene* scene, int stops_at_masks) {
  if (HAS_MASK && !stops_at_masks) return 1;
  return HAS_EMISSION ? hides_emitters(scene) : 0;
}

/// What is left of light along rays to or from the sensor.
FN realw unhindered_share_w(const Scene* scene, const Paths_w* path, maskw which, int stops_at_masks, Rays_w* rays) {
  if (!is_seen_through_w(scene, stops_at_masks)) {
    if (HAS_COUNT_RAYS) count_events(scene, COUNT_SHADOW, lanes_among(bits_w(which)));
    return sel_w(which & ~meets_any_w(scene, rays, which), splat_w(R(1.0)), splat_w(R(0.0)));
  }
  Paths_w ahead = *path;
  ahead.alive = which;
  ahead.rays = *rays;
  return passed_share_w(scene, &ahead, stops_at_masks);
}
