// SPDX-License-Identifier: MIT
// Least squares by polynomials that are orthogonal over the places (G. Forsythe, "Generation and Use of Orthogonal
// Polynomials for Data-Fitting with a Digital Computer", 1957), again and again with more weight where the last one was
// far off (C. Lawson, "Contributions to the Theory of Linear Least Maximum Approximation", 1961).
#include "kinds/polynomial_fit.h"

#include <algorithm>
#include <cmath>

namespace strahl::kinds {
namespace {

constexpr int rounds = 30;

/// Of the sum of all terms' sizes: what Horner's rule in single precision may lose, several roundings of 2^-24 each.
constexpr double loss_of_digits = 5e-7;

using Terms = PolynomialTerms;

/// An orthogonal polynomial: its terms, the highest power first, and its values at the places.
struct Orthogonal {
  Terms terms{};
  std::vector<double> values;
};

Terms by_least_squares(const std::vector<double>& x, const std::vector<double>& values,
                       const std::vector<double>& weights) {
  Terms fit{};
  Orthogonal before{{}, std::vector<double>(x.size(), 0)}, current{{}, std::vector<double>(x.size(), 1)};
  current.terms.back() = 1;
  double size_before = 1;
  for (std::size_t k = 0; k < fit.size(); ++k) {
    double size = 0, along = 0, middle = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double weighted = weights[i] * current.values[i];
      size += weighted * current.values[i];
      along += weighted * values[i];
      middle += weighted * current.values[i] * x[i];
    }
    if (!(size > 0)) break;
    middle /= size;
    const double back = k == 0 ? 0 : size / size_before;
    Orthogonal next{{}, std::vector<double>(x.size())};
    for (std::size_t t = 0; t < fit.size(); ++t) {
      fit[t] += along / size * current.terms[t];
      const double raised = t + 1 < fit.size() ? current.terms[t + 1] : 0;
      next.terms[t] = raised - middle * current.terms[t] - back * before.terms[t];
    }
    for (std::size_t i = 0; i < x.size(); ++i)
      next.values[i] = (x[i] - middle) * current.values[i] - back * before.values[i];
    before = std::move(current);
    current = std::move(next);
    size_before = size;
  }
  return fit;
}

}  // namespace

double share_of_polynomial(const PolynomialTerms& terms, double x) {
  double sum = 0;
  for (const double term : terms) sum = sum * x + term;
  return std::clamp(sum, 0.0, 1.0);
}

PolynomialFit polynomial_near(const std::vector<double>& x, const std::vector<double>& values,
                              const std::vector<double>& importance) {
  PolynomialFit best;
  std::vector<double> weights(x.size(), 1);
  for (int round = 0; round < rounds; ++round) {
    const Terms terms = by_least_squares(x, values, weights);
    double off = 0, sizes = 0, sum = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double here = importance[i] * std::fabs(share_of_polynomial(terms, x[i]) - values[i]);
      off = std::max(off, here);
      weights[i] *= here + 1e-5;
      sum += weights[i];
    }
    for (double& weight : weights) weight *= static_cast<double>(x.size()) / sum;
    for (const double term : terms) sizes += std::fabs(term);
    off += loss_of_digits * sizes;
    if (off < best.most_off) best = {terms, off};
  }
  return best;
}

}  // namespace strahl::kinds
