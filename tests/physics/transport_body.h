// SPDX-License-Identifier: MIT
// One tier of transport_tiers.h; needs REAL_BITS and TIER_.... No guard: once a unit.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "cl/host_features.h"
#include "physics/transport_tiers.h"

#define HAS_HIDE_EMITTERS 1
#define HAS_ERROR_SUMS 1
#define HAS_WIDE_BODIES (REAL_BITS == 32 && !TIER_FAST)
// Traversals are not inlined, as where lanes are wide: the unit compiles much faster.
#define SCENE_LANES 16

namespace strahl::test {
// Internal to the unit: the tiers' headers give their functions the same names.
namespace {
namespace tier {
#include "portable.h"
// The ground of what follows.
#include "math/vec3.h"
#include "scene/scene.h"

inline Scene scene_of(const TierBuffers& buffers) {
  Scene scene{};
  scene.geometry = static_cast<const real*>(buffers.geometry);
  scene.shading = static_cast<const real*>(buffers.shading);
  scene.index = buffers.index;
  return scene;
}

// Vectors wider than the processor's registers take the compiler as long as everything else. So lanes are compiled only
// where bodies of their own need them, and the widest only for packets in the default tier. The widest comes first: it
// decides for all widths whether spheres are put off (shapes/exact/put_off.h).
#if TIER_ROBUST
#define LANES 16
#include "physics/packets_width.h"
#undef LANES
#endif
#if HAS_WIDE_BODIES
#define LANES 8
#include "physics/transport_width.h"
#undef LANES
#endif
#define LANES 1
#include "physics/transport_width.h"
#undef LANES

inline std::vector<double> angles_alone(const std::vector<TexturePlace>& points) {
  std::vector<double> found;
  for (const TexturePlace& point : points) found.push_back(atan2_turns((real)point.v, (real)point.u));
  return found;
}

inline std::vector<TransportTier> transport(const char* name) {
#define QUESTIONS(lanes)                                                                               \
  {                                                                                                    \
    name, lanes, draw_lights_##lanes, area_places_##lanes, chosen_items_##lanes, look_along_##lanes,   \
        density_towards_##lanes, pick_lights_##lanes, rarity_of_##lanes, texture_values_##lanes,       \
        material_rows_##lanes, lit_places_##lanes, mapped_at_##lanes, angles_of_##lanes, angles_alone, \
        radiance_along_##lanes, splats_of_##lanes                                                      \
  }
  return {
    QUESTIONS(1),
#if HAS_WIDE_BODIES
        QUESTIONS(8)
#endif
  };
#undef QUESTIONS
}

#if HAS_WIDE_BODIES
inline PacketTier packets(const char* name) {
  return {name,
          find_alone_1,
          {{8, find_packets_8},
#if TIER_ROBUST
           {16, find_packets_16}
#endif
          },
          {{8, walked_lanes_8},
#if TIER_ROBUST
           {16, walked_lanes_16}
#endif
          }};
}
#endif
}  // namespace tier
}  // namespace
}  // namespace strahl::test
