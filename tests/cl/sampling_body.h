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
#include "areas/all.h"
#include "samplers/all.h"
}  // namespace tier
}  // namespace

namespace strahl::test {

namespace {

tier::real3 in(const Triple<tier::real>& v) { return tier::vec3(v[0], v[1], v[2]); }
Triple<tier::real> out(const tier::real3& v) { return {v.x, v.y, v.z}; }

}  // namespace

template <>
tier::real Maps<tier::real>::between(std::uint32_t bits) {
  return tier::random_between(bits);
}
template <>
Triple<tier::real> Maps<tier::real>::disk(tier::real u, tier::real v) {
  const tier::real2 p = tier::square_to_disk(u, v);
  return {p.x, p.y, 0};
}
template <>
Triple<tier::real> Maps<tier::real>::cosine_hemisphere(tier::real u, tier::real v) {
  return out(tier::square_to_cosine_hemisphere(u, v));
}
template <>
Triple<tier::real> Maps<tier::real>::sphere(tier::real u, tier::real v) {
  return out(tier::square_to_sphere(u, v));
}
template <>
Triple<tier::real> Maps<tier::real>::triangle(tier::real u, tier::real v) {
  const tier::real2 w = tier::square_to_triangle(u, v);
  return {w.x, w.y, 1 - w.x - w.y};
}
template <>
std::array<Triple<tier::real>, 2> Maps<tier::real>::frame(const Triple<tier::real>& n) {
  tier::real3 x, y;
  tier::frame_around(in(n), &x, &y);
  return {out(x), out(y)};
}
template <>
DrawnPoint<tier::real> Maps<tier::real>::point(AreaKind kind, const tier::real* area, const Triple<tier::real>& from,
                                               tier::real u, tier::real v) {
  constexpr decltype(&tier::disk_point) points[] = {tier::triangle_point, tier::parallelogram_point, tier::disk_point,
                                                    tier::sphere_point, tier::cylinder_point};
  const tier::AreaPoint p = points[static_cast<int>(kind)](area + tier::AREA_ITEMS, area, in(from), u, v);
  return {out(p.position), out(p.normal), p.density};
}
template <>
tier::real Maps<tier::real>::density(AreaKind kind, const tier::real* area, const Triple<tier::real>& from,
                                     const Triple<tier::real>& towards, const Triple<tier::real>& normal) {
  constexpr decltype(&tier::disk_density) densities[] = {tier::triangle_density, tier::parallelogram_density,
                                                         tier::disk_density, tier::sphere_density,
                                                         tier::cylinder_density};
  return densities[static_cast<int>(kind)](area + tier::AREA_ITEMS, area, in(from), in(towards), in(normal));
}

}  // namespace strahl::test
