// SPDX-License-Identifier: MIT
// One tier of bsdf_tiers.h; needs REAL_BITS and TIER_ROBUST. No guard: once a unit.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "cl/host_features.h"
#include "physics/bsdf_tiers.h"

namespace strahl::test {
// Internal to the unit: the tiers' headers give their functions the same names.
namespace {
namespace tier {
#include "portable.h"
// The ground of what follows.
#include "math/vec3.h"
#include "scene/scene.h"
#define LANES 1
#include "physics/bsdf_width.h"
#undef LANES
#define LANES 8
#include "physics/bsdf_width.h"
#undef LANES
#if REAL_BITS == 32
#define LANES 16
#include "physics/bsdf_width.h"
#undef LANES
#endif
}  // namespace tier
}  // namespace
}  // namespace strahl::test
