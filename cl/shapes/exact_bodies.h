// SPDX-License-Identifier: MIT
// Only includes, for exact_scalar.h: one lane.
#include "lanes/double_word.h"
#include "math/vec3_lanes.h"
#include "accel/slabs_lanes.h"
#include "shapes/quadratic_lanes.h"
#include "shapes/exact_rays_lanes.h"
#include "shapes/polygon_exact_lanes.h"
#include "shapes/sphere_exact_lanes.h"
#include "shapes/polygon_exact.h"
#include "shapes/sphere_exact.h"
#include "shapes/put_off.h"
