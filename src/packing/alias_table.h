// SPDX-License-Identifier: MIT
// Draws an item in proportion to its weight, in constant time (cl/lights/alias_lanes.h).
#pragma once

#include <cstdint>
#include <vector>

#include "packing/packed_scene.h"

namespace strahl {

/// A row of an alias table: with a number of 32 bits below the limit the row's own item, else the other.
struct Choice {
  std::uint32_t limit = 0xffffffff;
  std::int32_t other = 0;
};

/// Draws an item in proportion to its weight: all of them, one at least, finite and not negative, their sum positive.
/// A. Walker's method with M. Vose's table, "A Linear Algorithm for Generating Random Numbers with a Given
/// Distribution", IEEE Transactions on Software Engineering 17(9), 1991.
[[nodiscard]] std::vector<Choice> alias_table(const std::vector<double>& weights);

/// CHOICE_... of cl/scene/layout.h. Returns the offset of the first.
template <typename Real>
int put_choices(PackedScene<Real>& packed, const std::vector<Choice>& choices) {
  const int at = packed.index_end();
  for (const Choice& choice : choices) {
    packed.index.push_back(static_cast<std::int32_t>(choice.limit));
    packed.index.push_back(choice.other);
  }
  return at;
}

}  // namespace strahl
