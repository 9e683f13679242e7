// SPDX-License-Identifier: MIT
// What the tables of tiers have in common (bsdf_tiers.h, transport_tiers.h).
#pragma once

#include <array>
#include <cstdlib>
#include <string>
#include <vector>

namespace strahl::test {

using Triad = std::array<double, 3>;

/// Half the distance from 1 to the next larger number of the tier's reals.
template <class Tier>
[[nodiscard]] double roundoff(const Tier& tier) {
  return std::string(tier.name) == "double" ? 0x1p-53 : 0x1p-24;
}

/// Those of one lane, for laws that are asked of many numbers: another case holds that every width has the same bits.
/// All of them with STRAHL_ALL_WIDTHS.
template <class Tier>
[[nodiscard]] std::vector<Tier> asked_widths(std::vector<Tier> tiers) {
  if (std::getenv("STRAHL_ALL_WIDTHS") == nullptr)
    std::erase_if(tiers, [](const Tier& tier) { return tier.lanes > 1; });
  return tiers;
}

}  // namespace strahl::test
