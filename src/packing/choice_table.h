// SPDX-License-Identifier: MIT
// Draws an item in proportion to its weight, larger numbers for later items (cl/lights/choice_lanes.h).
#pragma once

#include <cstdint>
#include <vector>

#include "packing/packed_scene.h"

namespace strahl {

/// Row i of a table of n items, which numbers of 32 bits choose from.
struct Choice {
  std::uint32_t last = 0xffffffff;  ///< The last number that leads to item i or to one before it.
  std::int32_t guide = 0;           ///< The item that the first number of the i-th of n equal parts leads to.
};

/// All weights, one at least, finite and not negative, their sum positive. An item's numbers are its share of 2^32,
/// within one; items of weight 0 have none, all others at least one.
[[nodiscard]] std::vector<Choice> choice_table(const std::vector<double>& weights);

/// One over each item's chance to be drawn from the table of these weights; infinite where its weight is 0. It is that
/// of the item's numbers, or of its weight where both are the same for all items in single precision: n equal items
/// then weigh n.
[[nodiscard]] std::vector<double> choice_rarities(const std::vector<Choice>& table, const std::vector<double>& weights);

/// CHOICE_... of cl/scene/layout.h. Returns the offset of the first.
template <typename Real>
int put_choices(PackedScene<Real>& packed, const std::vector<Choice>& choices) {
  const int at = packed.index_end();
  for (const Choice& choice : choices) {
    packed.index.push_back(static_cast<std::int32_t>(choice.last));
    packed.index.push_back(choice.guide);
  }
  return at;
}

}  // namespace strahl
