// SPDX-License-Identifier: MIT
// Visibility between a surface and a light: where shadow rays of paths from the camera are traced (those of light
// paths: integrators/seen_through_lanes.h). The light is visible or not; what media and masks let through of it:
// media/seen_share_lanes.h. One width; no guard.

/// The lanes of `which` that see along `towards` until t_max. aim: as in Rays.
FN maskw sees_along_w(const Scene* scene, const Surfaces_w* s, maskw which, real3w towards, realw t_max, intw aim) {
  Rays_w shadow;
  rays_leaving_w(s, which, towards, t_max, &shadow);
  shadow.aim = aim;
  if (HAS_COUNT_RAYS) count_events(scene, COUNT_SHADOW, lanes_among(bits_w(which)));
  return which & ~meets_any_w(scene, &shadow, which);
}
