// SPDX-License-Identifier: MIT
// What comes through between a surface and a light: the one place where shadow rays are asked. Today all of it or
// nothing; where surfaces and media let a share through, that share is computed here. One width; no guard.

/// The lanes of `which` that see along `towards` until t_max. aim: as in Rays.
FN maskw sees_along_w(const Scene* scene, const Surfaces_w* s, maskw which, real3w towards, realw t_max, intw aim) {
  Rays_w shadow;
  rays_leaving_w(s, which, towards, t_max, &shadow);
  shadow.aim = aim;
  if (HAS_COUNT_RAYS) count_events(scene, COUNT_SHADOW, lanes_among(bits_w(which)));
  return which & ~meets_any_w(scene, &shadow, which);
}
