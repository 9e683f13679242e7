// SPDX-License-Identifier: MIT
// The polynomials that weigh samples are the pixel filters, on both sides of every pixel's middle.
#include <catch2/catch.hpp>
#include <cmath>

#include "kinds/filter_density.h"
#include "kinds/filter_taps.h"
#include "packing/cl_layout.h"

using strahl::Filter;
using strahl::FilterKind;
using namespace strahl::kinds;

namespace {

/// As the kernel evaluates it: the highest power first.
double tap_weight(const FilterTaps& taps, int tap, double offset) {
  const int side = taps.sides == 2 && offset >= 0 ? 2 * taps.reach + 1 : 0;
  const double* terms = &taps.terms.at(static_cast<std::size_t>((taps.reach + side + tap) * strahl::layout::TAP_TERMS));
  double value = 0;
  for (int k = 0; k < strahl::layout::TAP_TERMS; ++k) value = value * offset + terms[k];
  return value;
}

}  // namespace

TEST_CASE("weights of samples are the filter's values, whose integral is 1") {
  struct Row {
    Filter filter;
    int reach;
  };
  const auto [filter, reach] =
      GENERATE(Row{{}, 2}, Row{{FilterKind::gaussian, 0, 0.3}, 1}, Row{{FilterKind::gaussian, 0, 0.45}, 2},
               Row{{FilterKind::gaussian, 0, 1.1}, 4}, Row{{FilterKind::gaussian, 2.5, 1}, 2},
               Row{{FilterKind::tent}, 1}, Row{{FilterKind::tent, 1.5}, 1}, Row{{FilterKind::box, 1.5}, 1});
  const FilterTaps taps = filter_taps(filter);
  CAPTURE(filter.radius, filter.stddev);
  REQUIRE(taps.reach == reach);
  for (int tap = -reach; tap <= reach; ++tap)
    for (double offset = -0.4995; offset < 0.5; offset += 0.013) {
      CAPTURE(tap, offset);
      const double x = tap + offset, expected = std::fabs(x) > filter_radius(filter) ? 0 : filter_density(filter, x);
      CHECK(tap_weight(taps, tap, offset) == Approx(expected).margin(1.3e-4));
    }
}

TEST_CASE("samples count in their own pixel alone where the filter is no wider, or polynomials miss it") {
  const auto filter = GENERATE(Filter{FilterKind::box}, Filter{FilterKind::box, 0.5}, Filter{FilterKind::box, 0.8},
                               Filter{FilterKind::tent, 0.5}, Filter{FilterKind::gaussian, 0, 0.1},
                               Filter{FilterKind::gaussian, 0, 2}, Filter{FilterKind::tent, 1024});
  CAPTURE(filter.radius, filter.stddev);
  CHECK(filter_taps(filter).reach == 0);
}
