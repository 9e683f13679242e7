// SPDX-License-Identifier: MIT
// What the tables of tiers have in common (bsdf_tiers.h, transport_tiers.h).
#pragma once

#include <array>
#include <string>

namespace strahl::test {

using Triad = std::array<double, 3>;

/// Half the distance from 1 to the next larger number of the tier's reals.
template <class Tier>
[[nodiscard]] double roundoff(const Tier& tier) {
  return std::string(tier.name) == "double" ? 0x1p-53 : 0x1p-24;
}

}  // namespace strahl::test
