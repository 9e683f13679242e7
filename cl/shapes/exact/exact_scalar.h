// SPDX-License-Identifier: MIT
// Code that a program of any width needs at one lane as well: the exact tests of the few candidates that lanes have
// found. The results do not depend on the width, and one candidate costs less than a block. Robust tier.
#ifndef STRAHL_SHAPES_EXACT_SCALAR_H
#define STRAHL_SHAPES_EXACT_SCALAR_H

#include "shapes/exact/exact_t.h"

#if LANES == 16
#undef LANES
#define LANES 1
#include "lanes/lane_ops.h"
#include "shapes/exact/exact_bodies.h"
#undef LANES
#define LANES 16
#elif LANES == 8
#undef LANES
#define LANES 1
#include "lanes/lane_ops.h"
#include "shapes/exact/exact_bodies.h"
#undef LANES
#define LANES 8
#else
#include "shapes/exact/exact_bodies.h"
#endif

#endif
