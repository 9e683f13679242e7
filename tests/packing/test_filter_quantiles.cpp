// SPDX-License-Identifier: MIT
// The tables that samples are drawn from, against the filters' own distributions.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>

#include "packing/cl_layout.h"
#include "packing/pack.h"

using namespace strahl;

namespace {

constexpr int cells = layout::FILTER_CELLS;

std::vector<double> quantiles(const Filter& filter) { return filter_quantiles(filter, SamplerKind::independent); }

/// Simpson's rule; the densities are smooth on [from, to].
double integral(const std::function<double(double)>& f, double from, double to) {
  constexpr int steps = 2000;
  const double h = (to - from) / steps;
  double sum = f(from) + f(to);
  for (int i = 1; i < steps; ++i) sum += (i % 2 == 1 ? 4 : 2) * f(from + i * h);
  return sum * h / 3;
}

/// So much of the drawn offsets lies beyond x on both sides, where they are even within a cell.
double drawn_beyond(const std::vector<double>& q, double x) {
  const auto inner = std::lower_bound(q.begin(), q.end(), x, std::greater<>());
  if (inner == q.begin()) return 0;
  const auto i = static_cast<double>(inner - q.begin() - 1);
  const double outer = *(inner - 1), tail = i * i + (2 * i + 1) * (outer - x) / (outer - *inner);
  return tail / cells / cells;
}

/// Every quantile has its share of the density beyond it, and so has what lies between them. end: beyond it nothing is
/// drawn.
void check_distribution(const std::vector<double>& q, const std::function<double(double)>& density, double radius,
                        double end) {
  REQUIRE(q.size() == cells + 1);
  CHECK(q.front() == Approx(end).epsilon(1e-6));  // where the density is 0, the quantile is known to half the digits
  CHECK(q.back() == 0);
  const double whole = integral(density, 0, radius);
  for (int i = 1; i <= cells; i += 16) {
    INFO("quantile " << i);
    const double share = static_cast<double>(i) / cells;
    CHECK(integral(density, q[static_cast<std::size_t>(i)], radius) / whole == Approx(share * share).epsilon(1e-6));
  }
  for (int k = 1; k < 64; ++k) {
    const double x = radius * k / 64, beyond = integral(density, x, radius) / whole;
    INFO(x << " of " << radius);
    CHECK(drawn_beyond(q, x) == Approx(beyond).epsilon(0.01).margin(1e-6));
  }
}

}  // namespace

TEST_CASE("Tables descend to 0") {
  for (const Filter& filter : {Filter{FilterKind::box, 0, 0.5}, Filter{FilterKind::box, 1.7, 0.5},
                               Filter{FilterKind::tent, 0, 0.5}, Filter{FilterKind::tent, 2.5, 0.5},
                               Filter{FilterKind::gaussian, 0, 0.5}, Filter{FilterKind::gaussian, 1.5, 0.8}}) {
    const std::vector<double> q = quantiles(filter);
    REQUIRE(q.size() == cells + 1);
    CHECK(q.back() == 0);
    for (std::size_t i = 0; i < cells; ++i) CHECK(q[i] > q[i + 1]);
  }
}

TEST_CASE("The box's quantiles are exact") {
  const std::vector<double> q = quantiles({FilterKind::box, 0, 0.5}), wide = quantiles({FilterKind::box, 2, 0.5});
  for (int i = 0; i <= cells; ++i) {
    const double share = static_cast<double>(i) / cells;
    CHECK(q[static_cast<std::size_t>(i)] == 0.5 * (1 - share * share));
    CHECK(wide[static_cast<std::size_t>(i)] == 2 * (1 - share * share));
  }
}

TEST_CASE("The tent's quantiles follow its density") {
  for (const double radius : {1.0, 2.5}) {
    const Filter filter{FilterKind::tent, radius == 1 ? 0 : radius, 0.5};
    check_distribution(
        quantiles(filter), [&](double x) { return 1 - x / radius; }, radius, radius);
  }
}

TEST_CASE("The gaussian's quantiles follow its density, lowered so that it ends in 0") {
  struct Case {
    Filter filter;
    double radius;
  };
  for (const Case& c : {Case{{FilterKind::gaussian, 0, 0.5}, 2.0}, Case{{FilterKind::gaussian, 0, 1.25}, 5.0},
                        Case{{FilterKind::gaussian, 1.5, 0.8}, 1.5}, Case{{FilterKind::gaussian, 3, 0.5}, 3.0}}) {
    const double variance = c.filter.stddev * c.filter.stddev, floor = std::exp(-c.radius * c.radius / (2 * variance));
    check_distribution(
        quantiles(c.filter),
        [&](double x) { return floor * std::expm1((c.radius - x) * (c.radius + x) / (2 * variance)); }, c.radius,
        std::min(c.radius, 5.5 * c.filter.stddev));
  }
  // However far off it is cut.
  for (const double radius : {20.0, 1e6}) {
    const std::vector<double> q = quantiles({FilterKind::gaussian, radius, 0.5});
    CHECK(q.front() == 2.75);
    for (const double x : {0.5, 1.0, 1.5, 2.0})
      CHECK(drawn_beyond(q, x) == Approx(std::erfc(x / std::sqrt(0.5))).epsilon(0.01));
  }
}

TEST_CASE("A gaussian much wider than its radius is a parabola") {
  for (const double stddev : {1e4, 1e9, 1e308}) {
    const Filter filter{FilterKind::gaussian, 1.5, stddev};
    const auto parabola = [](double x) { return 1 - x * x / (1.5 * 1.5); };
    check_distribution(quantiles(filter), parabola, 1.5, 1.5);
    const FilterDensities densities = filter_densities(filter);
    REQUIRE(densities.values.size() == cells + 1);
    for (int i = 0; i <= cells; ++i)
      CHECK(densities.values[static_cast<std::size_t>(i)] ==
            Approx(parabola((2.0 * i / cells - 1) * 1.5) / 2).margin(1e-12));
  }
  // The two ways agree where one takes the place of the other.
  const std::vector<double> below = quantiles({FilterKind::gaussian, 1, 1023}),
                            above = quantiles({FilterKind::gaussian, 1, 1025});
  for (std::size_t i = 0; i < below.size(); ++i) CHECK(below[i] == Approx(above[i]).margin(1e-4));
}

TEST_CASE("The centre sampler's table holds zeros") {
  const std::vector<double> q = filter_quantiles({}, SamplerKind::centre);
  CHECK(q.size() == cells + 1);
  CHECK(std::all_of(q.begin(), q.end(), [](double x) { return x == 0; }));
}
