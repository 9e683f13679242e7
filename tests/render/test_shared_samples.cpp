// SPDX-License-Identifier: MIT
// The told interval where pixels share samples: white noise that a gaussian spreads over the pixels around, so that the
// realised error is known.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <iostream>
#include <random>
#include <vector>

#include "packing/filter_overlap.h"
#include "render/error_estimate.h"
#include "render/film_words.h"

namespace strahl::test {
namespace {

constexpr int edge_pixels = 48, samples_each = 8, picture_count = 200;
constexpr int most_beside = 2;  ///< A sample counts in the pixels up to so many beside its own.
constexpr double bell_stddev = 0.5, bell_radius = 2;
constexpr double mean_light = 8;  ///< So that no sum is negative.

/// Of one axis: a sample's weights in the pixels from `most_beside` before its own on, whose middle it is off.
std::array<double, 2 * most_beside + 1> weights_of(double offset) {
  const auto bell = [](double x) { return std::exp(-x * x / (2 * bell_stddev * bell_stddev)); };
  std::array<double, 2 * most_beside + 1> weights{};
  for (int i = -most_beside; i <= most_beside; ++i)
    weights[static_cast<std::size_t>(i + most_beside)] = std::max(0.0, bell(offset - i) - bell(bell_radius));
  return weights;
}

struct PixelSums {
  std::array<double, sub_sum_number> light{}, weight{};
};

/// Samples at random places of their pixels, spread by the filter; the pixels' sums.
std::vector<PixelSums> spread_noise(const SubSums& sums, std::mt19937_64& random) {
  std::uniform_real_distribution<double> off_middle(-0.5, 0.5);
  std::normal_distribution<double> noise(mean_light, 1);
  std::vector<PixelSums> film(edge_pixels * edge_pixels);
  for (int y = 0; y < edge_pixels; ++y)
    for (int x = 0; x < edge_pixels; ++x)
      for (int sample = 0; sample < samples_each; ++sample) {
        const auto across = weights_of(off_middle(random)), down = weights_of(off_middle(random));
        const double value = noise(random);
        const auto sub = static_cast<std::size_t>(sub_sum_of(sums, sample));
        for (int dy = std::max(-most_beside, -y); dy <= std::min(most_beside, edge_pixels - 1 - y); ++dy)
          for (int dx = std::max(-most_beside, -x); dx <= std::min(most_beside, edge_pixels - 1 - x); ++dx) {
            const double weight =
                across[static_cast<std::size_t>(dx + most_beside)] * down[static_cast<std::size_t>(dy + most_beside)];
            const double rounded = std::floor(weight / film_weight_unit + 0.5) * film_weight_unit;
            PixelSums& pixel = film[static_cast<std::size_t>((y + dy) * edge_pixels + x + dx)];
            pixel.light[sub] += rounded * value;
            pixel.weight[sub] += rounded;
          }
      }
  return film;
}

/// Writes the sums into a film; returns its true RMSE.
double fill_with(const std::vector<PixelSums>& sums, FilmSums& film) {
  std::fill(film.words.begin(), film.words.end(), 0);
  double squares = 0;
  for (std::size_t at = 0; at < sums.size(); ++at) {
    double total = 0, weight = 0;
    for (std::size_t sub = 0; sub < sub_sum_number; ++sub) {
      total += sums[at].light[sub];
      weight += sums[at].weight[sub];
      add_light(film, at, static_cast<int>(sub), sums[at].light[sub]);
      add_weight(film, at, static_cast<int>(sub), sums[at].weight[sub]);
    }
    squares += std::pow(total / weight - mean_light, 2);
  }
  return std::sqrt(squares / static_cast<double>(sums.size()));
}

/// In how many pictures the interval holds the true error; and if pixels were thought to share nothing.
struct HeldErrors {
  int within = 0, within_independent = 0;
};

HeldErrors held_by(const SubSums& sums) {
  FilmShape shape{FilmKind::pixels, edge_pixels, edge_pixels, sums, 0, 1, false, false};
  shape.has_weights = true;
  FilmSums film(shape);
  std::fill(film.samples.begin(), film.samples.end(), samples_each);
  std::mt19937_64 random(11);
  const double shared = noise_overlap({FilterKind::gaussian, bell_radius, bell_stddev});
  HeldErrors held;
  for (int picture = 0; picture < picture_count; ++picture) {
    const double rmse = fill_with(spread_noise(sums, random), film);
    const auto holds = [&](double overlap) {
      film.noise_overlap = overlap;
      const std::optional<ErrorEstimate> told = estimate_error(film);
      REQUIRE(told);
      return rmse >= told->rmse_low && rmse <= told->rmse_high ? 1 : 0;
    };
    held.within += holds(shared);
    held.within_independent += holds(1);
  }
  std::cout << sums.sequences << " sequences: " << held.within << " of " << picture_count
            << " inside, as of independent pixels " << held.within_independent << std::endl;
  return held;
}

void check_shared(const SubSums& sums) {
  const HeldErrors held = held_by(sums);
  CHECK(held.within >= 180);
  CHECK(held.within_independent <= held.within - 5);
}

TEST_CASE("two sequences: the interval holds where pixels share samples") { check_shared({sub_sum_number, 2, 1}); }
TEST_CASE("four sequences: the interval holds where pixels share samples") { check_shared({sub_sum_number, 4, 0}); }

}  // namespace
}  // namespace strahl::test
