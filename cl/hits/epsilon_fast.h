// SPDX-License-Identifier: MIT
// The fast tier's way to leave a surface: hits nearer than a fixed distance do not count, and the primitive that was
// left is a primitive like any other. Right for scenes of size 1 about the origin, wrong elsewhere, as everywhere where
// it is done: the other tiers leave by identity (hits/departure.h).
#ifndef STRAHL_CORE_EPSILON_FAST_H
#define STRAHL_CORE_EPSILON_FAST_H

/// In world units.
#define FAST_EPSILON R(1e-4)

#endif
