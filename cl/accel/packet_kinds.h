// SPDX-License-Identifier: MIT
// Bodies for packets: one primitive in every lane, a ray in each. A kind's <kind>_lanes.h says which it has; rays are
// asked one by one where it has none.
#ifndef STRAHL_ACCEL_PACKET_KINDS_H
#define STRAHL_ACCEL_PACKET_KINDS_H

enum { PACKET_BODY_NONE, PACKET_BODY_TRIANGLE, PACKET_BODY_PARALLELOGRAM, PACKET_BODY_SPHERE, PACKET_BODY_PLANE };

#endif
