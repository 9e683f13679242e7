// SPDX-License-Identifier: MIT
// Only includes, for exact_scalar.h: one lane.
#include "lanes/double_word.h"
#include "accel/slabs_lanes.h"
#include "shapes/quadratic_lanes.h"
#include "shapes/polygon_exact.h"
#include "shapes/polygon_take.h"
#include "shapes/sphere_exact.h"
