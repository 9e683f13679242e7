// SPDX-License-Identifier: MIT
// Polynomials near given values, for kernels that evaluate them in single precision by Horner's rule.
#pragma once

#include <array>
#include <vector>

namespace strahl::kinds {

using PolynomialTerms = std::array<double, 9>;  ///< The highest power first.

/// What the polynomial gives at x, held to [0, 1].
[[nodiscard]] double share_of_polynomial(const PolynomialTerms& terms, double x);

struct PolynomialFit {
  PolynomialTerms terms{};
  /// The greatest distance from the values of what the polynomial gives, held to [0, 1], times its importance, and what
  /// single precision may lose.
  double most_off = 2;
};

/// Nearly the one whose greatest distance, times the importance of its place, is the least. values: shares, at as many
/// places x in about [-1, 1].
[[nodiscard]] PolynomialFit polynomial_near(const std::vector<double>& x, const std::vector<double>& values,
                                            const std::vector<double>& importance);

}  // namespace strahl::kinds
