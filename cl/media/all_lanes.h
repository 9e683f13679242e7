// SPDX-License-Identifier: MIT
// What lies between surfaces. Only includes: a program without media holds none of it.
#include "phases/phase_lanes.h"  // of homogeneous
#include "media/flight_lanes.h"  // of homogeneous
#include "media/homogeneous_lanes.h"
#include "media/medium_lanes.h"      // of homogeneous
#include "media/vertex_lanes.h"      // of homogeneous
#include "media/seen_share_lanes.h"  // of homogeneous
