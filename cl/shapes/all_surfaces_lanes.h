// SPDX-License-Identifier: MIT
// Surfaces in lanes of the shapes that name a body, NAME_SURFACES in NAME_lanes.h, one width: flat_surfaces says what a
// body is given and returns. Only includes.
#include "shapes/polygon/flat_surfaces_lanes.h"  // of triangle, parallelogram
#include "shapes/sphere/sphere_surfaces_lanes.h"
#include "shapes/plane/plane_surfaces_lanes.h"
#include "shapes/box/box_surfaces_lanes.h"
#include "shapes/disk/disk_surfaces_lanes.h"
#include "shapes/cylinder/cylinder_surfaces_lanes.h"
