// SPDX-License-Identifier: MIT
// Every shape's body in lanes, one width. Only includes.
#include "shapes/sphere_lanes.h"
#include "shapes/plane_lanes.h"
#include "shapes/box_lanes.h"
#include "shapes/triangle_lanes.h"
#include "shapes/parallelogram_lanes.h"
#include "shapes/disk_lanes.h"
#include "shapes/cylinder_lanes.h"
