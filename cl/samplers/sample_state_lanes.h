// SPDX-License-Identifier: MIT
// Which samples are being taken, one a lane, of one pixel. All numbers are functions of it, so that a picture does not
// depend on how its samples were split into launches or devices. One width; no guard.
#include "math/rng_lanes.h"

typedef struct {
  uint pixel, seed;
  uint sequences;  ///< Interleaved by the sample's number.
  uintw sample;
  uintw reversed, key;  ///< The sampler's own: what it prepares for all sets.
} SampleState_w;

typedef struct {
  uintw x, y;
} Random2_w;
