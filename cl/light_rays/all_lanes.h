// SPDX-License-Identifier: MIT
// How light leaves each light that has a place. Only includes: a program holds those that its scene uses.
#include "light_rays/spread_lanes.h"  // of spot, projector
#include "light_rays/point_lanes.h"
#include "light_rays/spot_lanes.h"
#include "light_rays/projector_lanes.h"
#include "light_rays/collimated_lanes.h"
#include "light_rays/area_place_lanes.h"  // of area, directionalarea
#include "light_rays/area_lanes.h"
#include "light_rays/directionalarea_lanes.h"
#include "light_rays/far_lanes.h"  // of directional, constant, envmap, sun
#include "light_rays/directional_lanes.h"
#include "light_rays/constant_lanes.h"
#include "light_rays/envmap_lanes.h"
#include "light_rays/sun_lanes.h"
