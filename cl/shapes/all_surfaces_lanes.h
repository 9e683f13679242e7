// SPDX-License-Identifier: MIT
// Surfaces in lanes of the shapes that name a body, NAME_SURFACES in NAME_lanes.h, one width. A body fills the lanes of
// `which` that have hit a primitive of the kind, and returns those of them that are plain. Only includes.
#include "shapes/polygon/flat_surfaces_lanes.h"  // of triangle, parallelogram
#include "shapes/sphere/sphere_surfaces_lanes.h"
#include "shapes/plane/plane_surfaces_lanes.h"
#include "shapes/box/box_surfaces_lanes.h"
#include "shapes/disk/disk_surfaces_lanes.h"
#include "shapes/cylinder/cylinder_surfaces_lanes.h"
