// SPDX-License-Identifier: MIT
// Where samples lie in their pixels and on the lens, by their numbers. One width; no guard.

/// Where the sample lies in its pixel, from the middle.
FN Real2_w pixel_offset_w(const Scene* scene, const SampleState_w* sample) {
  Real2_w offset;
  offset.x = offset.y = splat_w(R(0.0));
  if (HAS_SHARED_SAMPLES) {
    // Anywhere in it: the filter weighs samples afterwards (film/shared_samples_lanes.h).
    if (scene->index[HEADER_TAP_REACH] == 0) return offset;
    Random2_w bits = sample_pair_w(scene, sample, USE_PIXEL);
    offset.x = random_unit_w(bits.x) - splat_w(R(0.5));
    offset.y = random_unit_w(bits.y) - splat_w(R(0.5));
  } else if (HAS_PIXEL_FILTER) {
    GLOBAL const real* quantiles = scene->shading + scene->index[HEADER_FILTER];
    Random2_w bits = sample_pair_w(scene, sample, USE_PIXEL);
    offset.x = filter_offset_w(quantiles, random_unit_w(bits.x));
    offset.y = filter_offset_w(quantiles, random_unit_w(bits.y));
  }
  return offset;
}

/// Where the sample's ray leaves the lens, in the unit disk.
FN Real2_w lens_point_w(const Scene* scene, const SampleState_w* sample) {
  Real2_w point;
  point.x = point.y = splat_w(R(0.0));
  if (HAS_THIN_LENS) {
    Random2_w bits = sample_pair_w(scene, sample, USE_LENS);
    point = square_to_disk_w(random_between_w(bits.x), random_between_w(bits.y));
  }
  return point;
}
