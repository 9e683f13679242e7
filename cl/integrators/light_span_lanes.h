// SPDX-License-Identifier: MIT
// Light paths of a span's samples; needs camera/span_lanes.h. One width; no guard.

/// As begin_paths of camera/span_lanes.h, for as many samples of the span as there are lanes.
FN NewPaths_w new_paths_w(const Scene* scene, Span* span) {
  intw numbers = splat_int_w(0), pixels = numbers;
  int first = (span->y - scene->splats->y) * scene->splats->columns + span->x - scene->splats->x;
  NewPaths_w begun;
  begun.which = span_take_w(span, (1u << LANES) - 1u, first, &numbers, &pixels);
  begun.pixels = uint_of_int_w(pixels);
  begun.numbers = uint_of_int_w(numbers);
  return begun;
}

FN NewPaths_w no_new_paths_w(void) {
  NewPaths_w begun;
  begun.which = none_w();
  begun.pixels = begun.numbers = splat_uint_w(0u);
  return begun;
}
