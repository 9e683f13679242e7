// SPDX-License-Identifier: MIT
// The samples that are being taken, one a lane. All random numbers are functions of this state, so that a
// picture does not depend on how its samples are split into launches or devices. One width; no guard.
#include "math/rng_lanes.h"

typedef struct {
  uintw pixel, sample;  ///< Numbers of the pixel in the picture and of the sample in the pixel.
  uint seed;
  uint sequences;       ///< Interleaved by the sample's number.
  uintw reversed, key;  ///< Prepared by the sampler for all sets.
} SampleState_w;

typedef struct {
  uintw x, y;
} Random2_w;
