// SPDX-License-Identifier: MIT
// Bodies for packets: every lane holds the same primitive and a ray of its own. A kind's <kind>_lanes.h says which body
// the kind has. From PACKET_BODY_CYLINDER on a kind has none that decides all. Then the robust tier finds in lanes the
// rays that come near the ball of a primitive (shapes/ball.h), and tests these rays one by one; of PACKET_BODY_CYLINDER
// doubles decide nearly all rays in lanes, and only the rest is tested so. The other tiers test all rays one by one.
#ifndef STRAHL_ACCEL_PACKET_KINDS_H
#define STRAHL_ACCEL_PACKET_KINDS_H

enum {
  PACKET_BODY_TRIANGLE,
  PACKET_BODY_PARALLELOGRAM,
  PACKET_BODY_SPHERE,
  PACKET_BODY_PLANE,
  PACKET_BODY_DISK,
  PACKET_BODY_CYLINDER,
  PACKET_BODY_NONE
};

#endif
