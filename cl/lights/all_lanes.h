// SPDX-License-Identifier: MIT
// Every light. Only includes: a program holds those that its scene uses.
#include "lights/point_lanes.h"
#include "lights/spot_lanes.h"
#include "lights/projector_lanes.h"
#include "lights/directional_lanes.h"
#include "lights/constant_lanes.h"
#include "lights/envmap_lanes.h"
#include "lights/sun_lanes.h"
#include "lights/collimated_lanes.h"
#include "lights/area_places_lanes.h"  // of area, directionalarea
#include "lights/area_lanes.h"
#include "lights/directionalarea_lanes.h"
