// SPDX-License-Identifier: MIT
// Which sample is being taken. All numbers are functions of it, so that a picture does not depend on how its samples
// were split into launches or devices.
#ifndef STRAHL_SAMPLERS_SAMPLE_STATE_H
#define STRAHL_SAMPLERS_SAMPLE_STATE_H

#include "math/rng.h"
#include "scene/layout.h"

typedef struct {
  uint pixel, sample, seed;
  uint reversed, key;  ///< The sampler's own: what it prepares for all sets.
} SampleState;

typedef struct {
  uint x, y;
} Random2;

#endif
