// SPDX-License-Identifier: MIT
// Values beside the picture (film/first_sample.h) where a boundary of media is what the camera meets first. One width;
// no guard.

/// s: the surfaces that the rays of the first samples meet otherwise.
FN void store_boundaries_w(const Scene* scene, const Paths_w* path, const Surfaces_w* s, const FirstSamples* first) {
  FirstSamples shown = no_first_samples_w();
  Way_w way = way_of_w(path, s);
  meet_boundaries_w(scene, &way, &shown);
  shown = *first;
  shown.lanes &= bits_w(way.crosses);
  if (shown.lanes == 0u) return;
  meet_boundaries_w(scene, &way, &shown);
  if (HAS_ALBEDO) store_albedo_w(scene, path, &way.met, &shown);
}
