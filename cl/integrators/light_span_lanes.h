// SPDX-License-Identifier: MIT
// Light paths of a span's samples; needs camera/span_lanes.h. One width; no guard.

/// As begin_paths of camera/span_lanes.h. Some samples of the span may end at once.
FN void begin_light_paths_w(const Scene* scene, Paths_w* path, Span* span) {
  intw numbers = splat_int_w(0), pixels = numbers, is_begun = numbers;
  int first = (span->y - scene->splats->y) * scene->splats->columns + span->x - scene->splats->x;
  for (uint idle = bits_w(~path->alive); idle != 0u && span->column < span->columns; idle &= idle - 1u) {
    int lane = first_bit(idle);
    put_int_w(&numbers, lane, span->next);
    put_int_w(&pixels, lane, first + span->column);
    put_int_w(&is_begun, lane, 1);
    if (++span->next < span->end) continue;
    span->next = span->first;
    ++span->column;
  }
  light_paths_begin_w(scene, path, nonzero_w(is_begun), uint_of_int_w(pixels), uint_of_int_w(numbers));
}
