// SPDX-License-Identifier: MIT
// How much noise pixels have in common, against sums that are known in closed form.
#include <catch2/catch.hpp>
#include <cmath>

#include "packing/filter_overlap.h"

using namespace strahl;

namespace {

/// 1-D correlations, squared: of shifts 1, 2 and 3.
double overlap_of(double one, double two = 0, double three = 0) {
  return std::pow(1 + 2 * (one * one + two * two + three * three), 2);
}

}  // namespace

TEST_CASE("boxes of a pixel at the most share nothing") {
  CHECK(noise_overlap({FilterKind::box, 0, 0.5}) == 1);
  CHECK(noise_overlap({FilterKind::box, 0.5, 0.5}) == 1);
  CHECK(noise_overlap({FilterKind::box, 0.2, 0.5}) == 1);
}

TEST_CASE("wider boxes share what lies in both") {
  CHECK(noise_overlap({FilterKind::box, 1, 0.5}) == Approx(overlap_of(0.5)));
  CHECK(noise_overlap({FilterKind::box, 2, 0.5}) == Approx(overlap_of(0.75, 0.5, 0.25)));
}

TEST_CASE("tents share a spline") {
  CHECK(noise_overlap({FilterKind::tent, 0, 0.5}) == Approx(overlap_of(0.25)).epsilon(1e-5));
  CHECK(noise_overlap({FilterKind::tent, 0.5, 0.5}) == 1);
}

TEST_CASE("gaussians share a gaussian, as far as their lowering allows") {
  const double whole = overlap_of(std::exp(-1), std::exp(-4), std::exp(-9));  // Of deviation 0.5.
  CHECK(noise_overlap({FilterKind::gaussian, 6, 0.5}) == Approx(whole).epsilon(1e-4));
  CHECK(noise_overlap({FilterKind::gaussian, 2, 0.5}) == Approx(1.6).epsilon(0.02));
  CHECK(noise_overlap({FilterKind::gaussian, 0, 0.5}) == noise_overlap({FilterKind::gaussian, 2, 0.5}));
  CHECK(noise_overlap({FilterKind::gaussian, 0.5, 0.5}) == 1);
  // Cut where it is still flat it is a parabola.
  CHECK(noise_overlap({FilterKind::gaussian, 1, 1e9}) == Approx(overlap_of(11 / 32.0)).epsilon(1e-4));
}
