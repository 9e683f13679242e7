// SPDX-License-Identifier: MIT
// Every light, after what several of them share. Only includes: a program holds the lights that its scene uses, and
// what is "of" some of them where it has one of those.
#if HAS_LIGHT_PATHS
#include "lights/light_ray_lanes.h"
#include "lights/lamp_rays_lanes.h"  // of spot, projector
#include "lights/far_rays_lanes.h"   // of directional, constant, envmap, sun
#endif
#include "lights/point_lanes.h"
#include "lights/spot_lanes.h"
#include "lights/projector_lanes.h"
#include "lights/directional_lanes.h"
#include "lights/constant_lanes.h"
#include "lights/envmap_lanes.h"
#include "lights/sun_lanes.h"
#include "lights/collimated_lanes.h"
#include "lights/area_places_lanes.h"  // of area, directionalarea
#if HAS_LIGHT_PATHS
#include "lights/area_rays_lanes.h"  // of area, directionalarea
#endif
#include "lights/area_lanes.h"
#include "lights/directionalarea_lanes.h"
