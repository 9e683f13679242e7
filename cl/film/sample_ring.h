// SPDX-License-Identifier: MIT
// Where samples wait for the pixels around them, in whose means the pixel filter lets them count
// (docs/decisions/0035-shared-samples.md): rows of pixels, in each RING_PLANES planes of a real for every sample, its
// colour and its place in the pixel. The rows are a ring: those that the next launch needs stay. Rays in lanes are
// samples of a pixel, so that these stand together; else a pixel is a work-item, and pixels stand together.
#ifndef STRAHL_FILM_SAMPLE_RING_H
#define STRAHL_FILM_SAMPLE_RING_H

#include "scene/layout.h"
#include "portable.h"

typedef struct {
  int rows, columns;
  int sample_first, samples;  ///< Of each pixel.
} SampleRing;

/// From a row's plane to its next.
FN int ring_plane(const SampleRing* ring) { return ring->columns * ring->samples; }
FN int ring_pixel_step(const SampleRing* ring) { return PATH_LANES == 1 ? 1 : ring->samples; }
FN int ring_sample_step(const SampleRing* ring) { return PATH_LANES == 1 ? ring->columns : 1; }

/// row: from the ring's beginning on, less than twice its length.
FN ulong ring_row(const SampleRing* ring, int row) { return (ulong)(row < ring->rows ? row : row - ring->rows); }

/// Where a pixel's first sample is.
FN ulong ring_place(const SampleRing* ring, int row, int column) {
  return ring_row(ring, row) * RING_PLANES * (ulong)ring_plane(ring) + (ulong)(column * ring_pixel_step(ring));
}

/// Where among the words behind the counters a pixel of the ring tells how far it has come.
FN ulong ring_pixel(const SampleRing* ring, int row, int column) {
  return ring_row(ring, row) * (ulong)ring->columns + (ulong)column;
}

#endif
