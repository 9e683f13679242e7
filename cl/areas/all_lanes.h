// SPDX-License-Identifier: MIT
// Every area. Only includes: a program holds those that its scene's emitters are made of.
#include "areas/triangle_lanes.h"
#include "areas/parallelogram_lanes.h"
#include "areas/disk_lanes.h"
#include "areas/sphere_lanes.h"
#include "areas/cylinder_lanes.h"
