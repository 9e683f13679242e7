// SPDX-License-Identifier: MIT
// Every shape's body in lanes, one width. Only includes.
#include "shapes/sphere/sphere_lanes.h"
#include "shapes/plane/plane_lanes.h"
#include "shapes/box/box_lanes.h"
#include "shapes/triangle/triangle_lanes.h"
#include "shapes/parallelogram/parallelogram_lanes.h"
#include "shapes/disk/disk_lanes.h"
#include "shapes/cylinder/cylinder_lanes.h"
