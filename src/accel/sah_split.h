// SPDX-License-Identifier: MIT
// Where to split a range of primitives in two.
#pragma once

#include <cstdint>
#include <span>

#include "accel/binary_tree.h"

namespace strahl::accel {

struct Split {
  std::uint32_t at = 0;  ///< Primitives that go left, which now stand first; 0: this is a leaf.
  float half_area = 0;   ///< Of the box around all of them.
};

/// Reorders the primitives. threads: how many may help to look at a large range.
[[nodiscard]] Split split_range(std::span<Primitive> primitives, const BuildOptions& options, int depth,
                                unsigned threads);

}  // namespace strahl::accel
