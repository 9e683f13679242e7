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

/// Begins samples of the span in lanes where no path is alive, as far as there are any. Returns the lanes that hold the
/// first sample of a pixel since now.
FN maskw begin_paths_w(const Scene* scene, Paths_w* path, Span* span) {
  GLOBAL const real* shading = scene->shading;
  GLOBAL const int* index = scene->index;
  intw numbers = int_of_uint_w(path->sample.sample), pixels = int_of_uint_w(path->sample.pixel);
  intw is_begun = splat_int_w(0);
  int first_pixel = span_pixel(span);
  for (uint idle = bits_w(~path->alive); idle != 0u && span->column < span->columns; idle &= idle - 1u) {
    int lane = first_bit(idle);
    put_int_w(&numbers, lane, span->next);
    put_int_w(&pixels, lane, first_pixel + span->column);
    put_int_w(&is_begun, lane, 1);
    if (++span->next < span->end) continue;
    span->next = span->first;
    ++span->column;
  }
  path->sample = sample_begin_w(scene, uint_of_int_w(pixels), uint_of_int_w(numbers));
  realw dx = splat_w(R(0.0)), dy = dx;
  if (HAS_PIXEL_FILTER) {
    Random2_w bits = sample_pair_w(scene, &path->sample, USE_PIXEL);
    dx = filter_offset_w(shading + index[HEADER_FILTER], random_unit_w(bits.x));
    dy = filter_offset_w(shading + index[HEADER_FILTER], random_unit_w(bits.y));
  }
  Real2_w lens;
  lens.x = lens.y = splat_w(R(0.0));
  if (HAS_THIN_LENS) {
    Random2_w bits = sample_pair_w(scene, &path->sample, USE_LENS);
    lens = square_to_disk_w(random_between_w(bits.x), random_between_w(bits.y));
  }
  Rays_w rays;
  intw columns = pixels - splat_int_w(span->y * span->width);
  camera_rays_w(shading + index[HEADER_CAMERA], span->width, span->height, columns, span->y, dx, dy, lens, &rays);
  paths_begin_w(scene, path, nonzero_w(is_begun), &rays);
  return nonzero_w(is_begun) & lt_int_w(numbers, splat_int_w(1));
}
