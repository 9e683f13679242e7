// SPDX-License-Identifier: MIT
// The polynomials that weigh samples are the pixel filters, on both sides of every pixel's middle.
#include <catch2/catch.hpp>
#include <cmath>
#include <cstddef>
#include <vector>

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

/// By the midpoint rule.
double integral(const Filter& filter) {
  constexpr int steps = 100000;
  const double radius = filter_radius(filter);
  double sum = 0;
  for (int i = 0; i < steps; ++i) sum += filter_density(filter, ((i + 0.5) / steps * 2 - 1) * radius);
  return sum / steps * 2 * radius;
}

}  // namespace

TEST_CASE("weights of samples are the filter's values, whose integral is 1") {
  struct Row {
    Filter filter;
    int reach;
  };
  const auto [filter, reach] = GENERATE(
      Row{{}, 2}, Row{{FilterKind::gaussian, 0, 0.3}, 1}, Row{{FilterKind::gaussian, 0, 0.45}, 2},
      Row{{FilterKind::gaussian, 0, 1.1}, 4}, Row{{FilterKind::gaussian, 2.5, 1}, 2}, Row{{FilterKind::tent}, 1},
      Row{{FilterKind::tent, 1.5}, 1}, Row{{FilterKind::box, 1.5}, 1}, Row{{FilterKind::mitchell}, 2},
      Row{{FilterKind::mitchell, 0, 0.5, -1, 2.5}, 2}, Row{{FilterKind::catmullrom}, 2}, Row{{FilterKind::lanczos}, 3},
      Row{{FilterKind::lanczos, 1}, 1}, Row{{FilterKind::lanczos, 2}, 2}, Row{{FilterKind::lanczos, 4}, 4});
  const double whole = integral(filter);
  const FilterTaps taps = filter_taps(filter);
  CAPTURE(filter.radius, filter.stddev);
  REQUIRE(taps.reach == reach);
  for (int tap = -reach; tap <= reach; ++tap)
    for (double offset = -0.4995; offset < 0.5; offset += 0.013) {
      CAPTURE(tap, offset);
      const double x = tap + offset;
      const double expected = std::fabs(x) > filter_radius(filter) ? 0 : filter_density(filter, x) / whole;
      CHECK(tap_weight(taps, tap, offset) == Approx(expected).margin(1.3e-4));
    }
}

TEST_CASE("filters with negative parts have Mitsuba's values") {
  // mi.load_dict({"type": "lanczos", "lobes": 2}).eval(x) of Mitsuba 3.9, at multiples of a quarter.
  struct Row {
    Filter filter;
    std::vector<double> values;
  };
  const auto [filter, values] = GENERATE(
      Row{{FilterKind::mitchell}, {0.888889, 0.782118, 0.534722, 0.256076, 0.055556, -0.023437, -0.034722, -0.014757}},
      Row{{FilterKind::catmullrom}, {1, 0.867188, 0.5625, 0.226562, 0, -0.070312, -0.0625, -0.023438}},
      Row{{FilterKind::lanczos}, {1, 0.890067, 0.607927, 0.27019, 0, -0.132871, -0.135095, -0.067791, 0, 0.030021}},
      Row{{FilterKind::lanczos, 2}, {1, 0.877354, 0.573159, 0.235347, 0, -0.084725, -0.063684, -0.017905}});
  for (std::size_t i = 0; i < values.size(); ++i)
    for (const double side : {-0.25, 0.25}) {
      CAPTURE(filter.radius, i);
      CHECK(filter_density(filter, side * static_cast<double>(i)) == Approx(values[i]).margin(1e-6));
    }
  CHECK(is_density(drawn_filter(filter)));
}

TEST_CASE("samples count in their own pixel alone where the filter is no wider, or polynomials miss it") {
  const auto filter = GENERATE(Filter{FilterKind::box}, Filter{FilterKind::box, 0.5}, Filter{FilterKind::box, 0.8},
                               Filter{FilterKind::tent, 0.5}, Filter{FilterKind::gaussian, 0, 0.1},
                               Filter{FilterKind::gaussian, 0, 2}, Filter{FilterKind::tent, 1024});
  CAPTURE(filter.radius, filter.stddev);
  CHECK(filter_taps(filter).reach == 0);
}
