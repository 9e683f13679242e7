// SPDX-License-Identifier: MIT
// How rays of the fast tier leave a surface: hits nearer than a fixed distance do not count, and the primitive that was
// left is treated like any other. This is right for scenes of size 1 about the origin and wrong elsewhere, as in every
// renderer that does it. The other tiers exclude the primitive by its id (hits/departure.h).
#ifndef STRAHL_HITS_EPSILON_FAST_H
#define STRAHL_HITS_EPSILON_FAST_H

/// In world units.
#define FAST_EPSILON R(1e-4)

#endif
