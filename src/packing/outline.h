// SPDX-License-Identifier: MIT
// A few boxes in place of a group's many, from which each instance gets its own (docs/decisions/0009-instances.md).
#pragma once

#include <cstddef>
#include <vector>

#include "kinds/bounds.h"

namespace strahl {

/// Boxes that an outline should have where so many instances go through it.
[[nodiscard]] std::size_t outline_size(std::size_t instances);

/// Boxes that together hold all of `boxes`: these, or where they are more than `most`, one for each cell of a grid in
/// which some have their middles, about as many. A function of the boxes alone, whatever tree holds them. Instantiated
/// for float and double.
template <typename Real>
[[nodiscard]] std::vector<Bounds<Real>> outline(std::vector<Bounds<Real>> boxes, std::size_t most);

}  // namespace strahl
