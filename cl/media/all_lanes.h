// SPDX-License-Identifier: MIT
// What lies between surfaces. Only includes: a program without media holds none of it.
#include "phases/phase_lanes.h"  // of homogeneous, heterogeneous
#include "media/flight_lanes.h"  // of homogeneous, heterogeneous
#include "media/volume_lanes.h"  // of heterogeneous
#include "media/march_lanes.h"   // of heterogeneous
#include "media/homogeneous_lanes.h"
#include "media/heterogeneous_lanes.h"
#include "media/medium_lanes.h"        // of homogeneous, heterogeneous
#include "media/reach_lanes.h"         // of homogeneous, heterogeneous
#include "media/ranked_media_lanes.h"  // of homogeneous, heterogeneous
#include "media/boundaries_lanes.h"    // of homogeneous, heterogeneous
#include "media/vertex_lanes.h"        // of homogeneous, heterogeneous
#include "media/open_way_lanes.h"      // of homogeneous, heterogeneous
#include "media/seen_share_lanes.h"    // of homogeneous, heterogeneous
