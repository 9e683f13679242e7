// SPDX-License-Identifier: MIT
// What the canary asks: cases a property, the results that show it, and what IEEE 754 says they are.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace strahl {

namespace layout {
#include "../../cl/kernels/canary_layout.h"
}

template <typename Real>
using CanaryCase = std::array<Real, layout::CANARY_INPUTS>;

/// Numbered as the table of canary.cpp counts.
enum class CanaryProperty {
  finite_arithmetic,
  order,
  conversions,
  nan_compares,
  infinities,
  sums,
  contraction,
  products,
  division,
  square_root,
  denormals,
  fma_denormals,
  literal_zeros,
  builtin_min_max,
  long_loops,
};

template <typename Real>
struct CanaryGroup {
  CanaryProperty property;
  std::vector<int> outputs;  ///< CANARY_SUM, ...: those that show the property.
  std::vector<CanaryCase<Real>> cases;
};

/// Deterministic. Instantiated for float and double.
template <typename Real>
[[nodiscard]] std::vector<CanaryGroup<Real>> canary_groups();

/// The result of one operation on one case, computed on the host.
template <typename Real>
[[nodiscard]] Real canary_expected(int output, const CanaryCase<Real>& input);

}  // namespace strahl
