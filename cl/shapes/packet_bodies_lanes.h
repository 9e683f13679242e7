// SPDX-License-Identifier: MIT
// Bodies for packets (accel/packet_kinds.h). One width; no guard.
#if TIER_ROBUST
#include "shapes/packet_rough_lanes.h"
#endif
#include "shapes/polygon_packet_lanes.h"
#include "shapes/sphere_packet_lanes.h"
#include "shapes/plane_packet_lanes.h"
#include "shapes/packet_near_lanes.h"
