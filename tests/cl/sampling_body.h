// SPDX-License-Identifier: MIT
// Maps of one tier; needs REAL_BITS. No guard: once a unit.
#include <cmath>
#include <cstdint>
#include <cstring>

#include "cl/host_features.h"
#include "cl/sampling_tiers.h"

// Internal to the unit: both tiers' headers give their functions the same names.
namespace {
namespace tier {
#include "portable.h"
// The ground of what follows.
#include "math/vec3.h"
#include "scene/scene.h"
#define LANES 1
#include "lanes/lane_ops.h"
// Lanes come first: they define what the rest is written in.
#include "math/vec3_lanes.h"
// Each needs what is above it.
#include "math/sampling_lanes.h"
// As above.
#include "samplers/sample_state_lanes.h"
// As above.
#include "areas/area_point_lanes.h"
// As above.
#include "areas/all_lanes.h"
#include "samplers/all_lanes.h"
}  // namespace tier
}  // namespace

namespace strahl::test {

namespace {

tier::real3 in(const Triple<tier::real>& v) { return tier::vec3(v[0], v[1], v[2]); }
Triple<tier::real> out(const tier::real3& v) { return {v.x, v.y, v.z}; }

}  // namespace

template <>
tier::real Maps<tier::real>::between(std::uint32_t bits) {
  return tier::random_between_w_1(bits);
}
template <>
Triple<tier::real> Maps<tier::real>::disk(tier::real u, tier::real v) {
  const tier::Real2_w_1 p = tier::square_to_disk_w_1(u, v);
  return {p.x, p.y, 0};
}
template <>
Triple<tier::real> Maps<tier::real>::cosine_hemisphere(tier::real u, tier::real v) {
  return out(tier::square_to_cosine_hemisphere_w_1(u, v));
}
template <>
Triple<tier::real> Maps<tier::real>::sphere(tier::real u, tier::real v) {
  return out(tier::square_to_sphere_w_1(u, v));
}
template <>
Triple<tier::real> Maps<tier::real>::triangle(tier::real u, tier::real v) {
  const tier::Real2_w_1 w = tier::square_to_triangle_w_1(u, v);
  return {w.x, w.y, 1 - w.x - w.y};
}
template <>
std::array<Triple<tier::real>, 2> Maps<tier::real>::frame(const Triple<tier::real>& n) {
  const tier::Frame_w_1 frame = tier::frame_around_w_1(in(n));
  return {out(frame.x), out(frame.y)};
}
template <>
DrawnPoint<tier::real> Maps<tier::real>::point(AreaKind kind, const tier::real* area, const Triple<tier::real>& from,
                                               tier::real u, tier::real v) {
  constexpr decltype(&tier::disk_point_w_1) points[] = {tier::triangle_point_w_1, tier::parallelogram_point_w_1,
                                                        tier::disk_point_w_1, tier::sphere_point_w_1,
                                                        tier::cylinder_point_w_1};
  const tier::AreaPoint_w_1 p = points[static_cast<int>(kind)](area + tier::AREA_ITEMS, area, in(from), u, v);
  return {out(p.position), out(p.normal), p.density};
}
template <>
tier::real Maps<tier::real>::density(AreaKind kind, const tier::real* area, const Triple<tier::real>& from,
                                     const Triple<tier::real>& towards, const Triple<tier::real>& normal) {
  constexpr decltype(&tier::disk_density_w_1) densities[] = {tier::triangle_density_w_1,
                                                             tier::parallelogram_density_w_1, tier::disk_density_w_1,
                                                             tier::sphere_density_w_1, tier::cylinder_density_w_1};
  return densities[static_cast<int>(kind)](area + tier::AREA_ITEMS, area, in(from), in(towards), in(normal));
}

}  // namespace strahl::test
