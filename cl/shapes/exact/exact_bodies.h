// SPDX-License-Identifier: MIT
// Only includes, for exact_scalar.h: one lane.
#include "lanes/double_word.h"
#include "math/vec3_lanes.h"
#include "accel/slabs_lanes.h"
#include "shapes/exact/quadratic_lanes.h"
#include "shapes/exact/near_hits_lanes.h"
#include "shapes/polygon/polygon_exact_lanes.h"
#include "shapes/sphere/sphere_exact_lanes.h"
#include "shapes/polygon/polygon_exact.h"
#include "shapes/sphere/sphere_exact.h"
#include "shapes/exact/put_off.h"
