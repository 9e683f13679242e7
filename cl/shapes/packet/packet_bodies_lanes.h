// SPDX-License-Identifier: MIT
// Bodies for packets (accel/packet_kinds.h). One width; no guard.
#if TIER_ROBUST
#include "shapes/packet/packet_approximate_lanes.h"
#endif
#include "shapes/polygon/polygon_packet_lanes.h"
#include "shapes/sphere/sphere_packet_lanes.h"
#include "shapes/plane/plane_packet_lanes.h"
#include "shapes/packet/packet_near_lanes.h"
#include "shapes/disk/disk_body_lanes.h"
#include "shapes/cylinder/cylinder_body_lanes.h"
