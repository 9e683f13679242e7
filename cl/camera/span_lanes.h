// SPDX-License-Identifier: MIT
// Samples of a span, pixels beside each other in a row, as paths in lanes. A span is one pixel unless its samples are
// too few to fill a pool (docs/decisions/0026-path-pool.md). One width; no guard.

/// Samples [first, end) of `columns` pixels from (x, y) of a picture of width x height on. The next to begin is sample
/// `next` of pixel x + column.
typedef struct {
  int x, y, columns, width, height;
  int first, end, column, next;
} Span;

/// Samples that have not begun yet.
FN int span_left(const Span* span) {
  return (span->columns - span->column) * (span->end - span->first) - (span->next - span->first);
}

/// The number in the picture of its first pixel.
FN int span_pixel(const Span* span) { return span->y * span->width + span->x; }

/// Takes the span's next samples, one for each lane of `idle`, as far as there are any. numbers, pixels: get their
/// numbers, and their pixels where the span's first is first_pixel. Returns the lanes that have got one.
FN maskw span_take_w(Span* span, uint idle, int first_pixel, PRIVATE intw* numbers, PRIVATE intw* pixels) {
#if LANES != 1
  // Most often all lanes begin samples of one pixel, and the pixel has more than those.
  if (idle == bits_w(~none_w()) && span->column < span->columns && span->next + LANES < span->end) {
    *numbers = splat_int_w(span->next) + int_of_uint_w(lane_numbers_w());
    *pixels = splat_int_w(first_pixel + span->column);
    span->next += LANES;
    return ~none_w();
  }
#endif
  intw is_begun = splat_int_w(0);
  for (; idle != 0u && span->column < span->columns; idle &= idle - 1u) {
    int lane = first_bit(idle);
    put_int_w(numbers, lane, span->next);
    put_int_w(pixels, lane, first_pixel + span->column);
    put_int_w(&is_begun, lane, 1);
    if (++span->next < span->end) continue;
    span->next = span->first;
    ++span->column;
  }
  return nonzero_w(is_begun);
}

/// Samples that have just begun.
typedef struct {
  maskw which, are_first;  ///< Of them, the first of their pixels.
  Real2_w offset;          ///< From the pixel's middle.
} BegunSamples_w;

/// Begins samples of the span in lanes where no path is alive, as far as there are any.
FN BegunSamples_w begin_paths_w(const Scene* scene, Paths_w* path, Span* span) {
  intw numbers = int_of_uint_w(path->sample.sample), pixels = int_of_uint_w(path->sample.pixel);
  maskw is_begun = span_take_w(span, bits_w(~path->alive), span_pixel(span), &numbers, &pixels);
  path->sample = sample_begin_w(scene, uint_of_int_w(pixels), uint_of_int_w(numbers));
  Real2_w offset = pixel_offset_w(scene, &path->sample), lens = lens_point_w(scene, &path->sample);
  Rays_w rays;
  intw columns = pixels - splat_int_w(span->y * span->width);
  camera_rays_w(scene->shading + scene->index[HEADER_CAMERA], span->width, span->height, columns, span->y, offset.x,
                offset.y, lens, &rays);
  paths_begin_w(scene, path, is_begun, &rays);
  BegunSamples_w begun;
  begun.which = is_begun;
  begun.are_first = is_begun & lt_int_w(numbers, splat_int_w(1));
  begun.offset = offset;
  return begun;
}
