// SPDX-License-Identifier: MIT
// Samples of a pixel in a pool, with other pixels' before and behind them, added in lanes
// (cl/film/pixel_samples_lanes.h) leave the words that they leave one by one, in sums of any top and of any pattern of
// turns. Of what they were: test_film.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>

#include "cl/pixel_samples_tiers.h"
#include "packing/cl_layout.h"

using namespace strahl::test;

namespace {

/// What the samples of a pool are like.
enum class PoolLight { usual, dark, bright, any, black, faulty };

template <class Real>
class PoolSamples {
 public:
  std::vector<std::array<Real, 3>> draw(std::size_t count, PoolLight light) {
    std::vector<std::array<Real, 3>> samples(count);
    for (std::array<Real, 3>& sample : samples) {
      const bool is_black = random_() % 4 == 0;
      for (Real& channel : sample) channel = is_black ? Real(0) : value(light);
    }
    return samples;
  }
  std::mt19937& random() { return random_; }

 private:
  Real value(PoolLight light) {
    const auto between = [&](double low, double high) {
      return static_cast<Real>(std::pow(10.0, std::uniform_real_distribution<double>(low, high)(random_)));
    };
    switch (light) {
      case PoolLight::usual:
        return between(-5, 5);
      case PoolLight::dark:
        return between(-30, -6.5);
      case PoolLight::bright:
        return between(3, 9);
      case PoolLight::any:
        return between(-40, 38);
      case PoolLight::black:
        return random_() % 2 == 0 ? Real(0) : -Real(0);
      case PoolLight::faulty:
        break;
    }
    switch (random_() % 24) {
      case 0:
        return std::numeric_limits<Real>::quiet_NaN();
      case 1:
        return std::numeric_limits<Real>::infinity();
      case 2:
        return -between(-5, 5);
      default:
        return between(-5, 5);
    }
  }

  std::mt19937 random_{11};
};

}  // namespace

TEMPLATE_TEST_CASE("samples in lanes leave the words of samples one by one", "", float, double) {
  PoolSamples<TestType> samples;
  std::mt19937& random = samples.random();
  constexpr std::array all{PoolLight::usual, PoolLight::dark,  PoolLight::bright,
                           PoolLight::any,   PoolLight::black, PoolLight::faulty};
  for (int trial = 0; trial < 6000; ++trial) {
    PixelSums lanes;
    lanes.sequences = 1 << random() % 3;
    lanes.count = std::min<int>(lanes.sequences << random() % 2, strahl::layout::FILM_SUBSUMS);
    lanes.turn_bits = static_cast<int>(random() % 7);
    lanes.words.assign(static_cast<std::size_t>(lanes.count) * 3, FilmWords{});
    lanes.counts = {};
    PixelSums single = lanes;
    int first = static_cast<int>(random() % 100);
    // Several pools of one kind, then of another: the sums have a top by then.
    const std::array kinds{all.at(random() % all.size()), all.at(random() % all.size())};
    for (int pool = 0; pool < 4; ++pool) {
      const std::size_t count = pool == 0 ? 64 : 1 + random() % 64;
      const auto light = samples.draw(count, kinds.at(static_cast<std::size_t>(pool / 2)));
      const int place = static_cast<int>(random() % (65 - count));
      add_in_lanes(lanes, first, place, light);
      add_one_by_one(single, first, light);
      first += static_cast<int>(count);
      CAPTURE(trial, pool, static_cast<int>(kinds[0]), static_cast<int>(kinds[1]), lanes.count, lanes.sequences);
      REQUIRE(lanes.words == single.words);
      REQUIRE(lanes.counts == single.counts);
    }
  }
}

TEMPLATE_TEST_CASE("a pool of the largest usual samples fits", "", float, double) {
  PixelSums lanes{1, 1, 0, std::vector<FilmWords>(3), {}};
  PixelSums single = lanes;
  const TestType largest = std::nextafter(TestType(0x1p20), TestType(0));
  const std::vector<std::array<TestType, 3>> light(64, {largest, largest, TestType(0x1p-20)});
  add_in_lanes(lanes, 0, 0, light);
  add_one_by_one(single, 0, light);
  CHECK(lanes.words == single.words);
}
