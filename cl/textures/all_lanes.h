// SPDX-License-Identifier: MIT
// Every texture. Only includes: a program holds those that its scene uses.
#include "textures/checkerboard_lanes.h"
#include "textures/bitmap_lanes.h"
#include "textures/mesh_attribute_lanes.h"
