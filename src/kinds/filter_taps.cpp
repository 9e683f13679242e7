// SPDX-License-Identifier: MIT
#include "kinds/filter_taps.h"

#include <array>
#include <cmath>
#include <optional>

#include "kinds/filter_density.h"
#include "packing/cl_layout.h"

namespace strahl::kinds {
namespace {

constexpr std::size_t terms = layout::TAP_TERMS;
using Polynomial = std::array<double, terms>;  ///< The lowest power first.

/// Offsets from the middle of a pixel.
struct Side {
  double from, to;
};

double value_of(const Polynomial& polynomial, double offset) {
  double value = 0;
  for (std::size_t k = terms; k-- > 0;) value = value * offset + polynomial[k];
  return value;
}

double density_at(const Filter& filter, double x) {
  return std::fabs(x) > filter_radius(filter) ? 0 : filter_density(filter, x);
}

/// Through the filter at Chebyshev's places.
Polynomial polynomial_of(const Filter& filter, int tap, const Side& side) {
  std::array<double, terms> at{}, difference{};
  for (std::size_t i = 0; i < terms; ++i) {
    const double turn = std::acos(-1.0) * (static_cast<double>(i) + 0.5) / terms;
    at[i] = (side.from + side.to) / 2 - (side.to - side.from) / 2 * std::cos(turn);
    difference[i] = density_at(filter, tap + at[i]);
  }
  for (std::size_t order = 1; order < terms; ++order)
    for (std::size_t i = terms - 1; i >= order; --i)
      difference[i] = (difference[i] - difference[i - 1]) / (at[i] - at[i - order]);
  // Newton's form, multiplied out.
  Polynomial polynomial{};
  for (std::size_t i = terms; i-- > 0;) {
    for (std::size_t k = terms - 1; k > 0; --k) polynomial[k] = polynomial[k - 1] - at[i] * polynomial[k];
    polynomial[0] = difference[i] - at[i] * polynomial[0];
  }
  return polynomial;
}

double integral(const Polynomial& polynomial, const Side& side) {
  double sum = 0, from = side.from, to = side.to;
  for (std::size_t k = 0; k < terms; ++k, from *= side.from, to *= side.to)
    sum += polynomial[k] * (to - from) / static_cast<double>(k + 1);
  return sum;
}

/// Beyond what weights in the film can tell.
constexpr double most_off = 0.5 / (1 << layout::WEIGHT_BITS);

bool is_near(const Filter& filter, int tap, const Side& side, const Polynomial& polynomial) {
  constexpr int places = 128;
  for (int i = 0; i < places; ++i) {
    const double offset = side.from + (side.to - side.from) * (i + 0.5) / places;
    if (std::fabs(value_of(polynomial, offset) - density_at(filter, tap + offset)) > most_off) return false;
  }
  return true;
}

/// None where a polynomial misses the filter.
std::optional<FilterTaps> taps_with(const Filter& filter, int reach, const std::vector<Side>& sides) {
  FilterTaps taps;
  taps.reach = reach;
  taps.sides = static_cast<int>(sides.size());
  double whole = 0;
  for (const Side& side : sides)
    for (int tap = -reach; tap <= reach; ++tap) {
      const Polynomial polynomial = polynomial_of(filter, tap, side);
      if (!is_near(filter, tap, side, polynomial)) return std::nullopt;
      whole += integral(polynomial, side);
      taps.terms.insert(taps.terms.end(), polynomial.rbegin(), polynomial.rend());
    }
  for (double& term : taps.terms) term /= whole;
  return taps;
}

}  // namespace

FilterTaps single_tap() {
  FilterTaps taps;
  taps.terms.assign(terms, 0.0);
  taps.terms.back() = 1;
  return taps;
}

FilterTaps filter_taps(const Filter& filter) {
  const double reach = std::ceil(filter_radius(filter) + 0.5) - 1;
  if (!(reach >= 1 && reach <= most_filter_reach)) return single_tap();
  std::optional<FilterTaps> taps = taps_with(filter, static_cast<int>(reach), {{-0.5, 0.5}});
  if (!taps) taps = taps_with(filter, static_cast<int>(reach), {{-0.5, 0}, {0, 0.5}});
  return taps ? *taps : single_tap();
}

}  // namespace strahl::kinds
