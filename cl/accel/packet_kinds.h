// SPDX-License-Identifier: MIT
// Bodies for packets: one primitive in every lane, a ray in each. A kind's <kind>_lanes.h says which it has. Of a kind
// that has none only the rays that come near its ball (shapes/ball.h) are found in lanes (robust tier; else all may
// be): each is then asked by itself.
#ifndef STRAHL_ACCEL_PACKET_KINDS_H
#define STRAHL_ACCEL_PACKET_KINDS_H

enum { PACKET_BODY_TRIANGLE, PACKET_BODY_PARALLELOGRAM, PACKET_BODY_SPHERE, PACKET_BODY_PLANE, PACKET_BODY_NONE };

#endif
