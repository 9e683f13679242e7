// SPDX-License-Identifier: MIT
// The fast tier's way to leave a surface: hits nearer than a fixed distance do not count, and the primitive that was
// left is a primitive like any other. Right for scenes of size 1 about the origin, wrong elsewhere, as everywhere where
// it is done: the other tiers leave by identity (core/departure.h).
#ifndef STRAHL_CORE_EPSILON_FAST_H
#define STRAHL_CORE_EPSILON_FAST_H

#include "math/vec3.h"

/// In world units.
#define FAST_EPSILON R(1e-4)

/// The least t that counts of a ray along d that has left a surface.
FN real t_min_past_epsilon(real3 d) { return FAST_EPSILON / real_sqrt(dot3(d, d)); }

#endif
