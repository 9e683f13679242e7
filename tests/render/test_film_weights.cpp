// SPDX-License-Identifier: MIT
// A film of weighted samples: its pixels are divided by the sums of weights that their words end with.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <vector>

#include "packing/cl_layout.h"
#include "render/error_estimate.h"
#include "render/film_words.h"

namespace strahl::test {
namespace {

FilmShape weighted(int width, int height, SubSums sums = {sub_sum_number, 4, 0}, bool has_squares = false) {
  FilmShape shape{FilmKind::pixels, width, height, sums, 0, 1, has_squares, false};
  shape.has_weights = true;
  return shape;
}

TEST_CASE("weights are the last words of a pixel, two of them a word") {
  FilmShape shape = weighted(1, 1);
  CHECK(shape.words_per_pixel() == shape.words_of_sums() + 2);
  shape.has_squares = true;
  CHECK(shape.words_per_pixel() == shape.words_of_sums() / sub_sum_number * (sub_sum_number + 1) + 2);
  CHECK(weighted(1, 1, {2, 2, 0}).words_of_weights() == 1);
  CHECK(weighted(1, 1, {1, 1, 0}).words_of_weights() == 1);
  shape.has_weights = false;
  CHECK(shape.words_of_weights() == 0);
}

TEST_CASE("a mean is the sum of weighted samples over the sum of weights") {
  FilmSums film(weighted(3, 1));
  film.unit = 2;
  film.samples = {4, 4, 4};
  const double weights[sub_sum_number] = {0.75, 1.5, 0.25, 0.5};
  for (int sub = 0; sub < sub_sum_number; ++sub) {
    add_light(film, 1, sub, sub * weights[sub]);
    add_weight(film, 1, sub, weights[sub]);
    add_light(film, 2, sub, 3);  // Nothing says what it is to be divided by.
  }
  CHECK(film.rows().sub_sum_weights(1) == SubSumWeights{0.75, 1.5, 0.25, 0.5});
  CHECK(film.rows().sub_sum_weights(2) == SubSumWeights{});
  const auto mean = static_cast<float>(2 * (1 * 1.5 + 2 * 0.25 + 3 * 0.5) / 3);
  CHECK(film.mean().data == std::vector<float>{0, 0, 0, mean, mean, mean, 0, 0, 0});
}

TEST_CASE("sums of weights may be negative, each in its half") {
  FilmSums film(weighted(2, 1));
  film.samples = {4, 4};
  const SubSumWeights weights{-0.25, 0.5, 0.75, -std::ldexp(1, 18)};
  for (int sub = 0; sub < sub_sum_number; ++sub)
    for (const double part : {0.5, -1.0, 0.5}) add_weight(film, 0, sub, part * weights[static_cast<std::size_t>(sub)]);
  CHECK(film.rows().sub_sum_weights(0) == SubSumWeights{});
  for (int sub = 0; sub < sub_sum_number; ++sub) add_weight(film, 0, sub, weights[static_cast<std::size_t>(sub)]);
  CHECK(film.rows().sub_sum_weights(0) == weights);
  CHECK(film.rows().sub_sum_weights(1) == SubSumWeights{});
}

TEST_CASE("the only sub-sum has a word for its weight") {
  FilmSums film(weighted(2, 1, {1, 1, 0}));
  film.samples = {1, 1};
  for (const std::size_t pixel : {0U, 1U}) add_light(film, pixel, 0, 12);
  film.words[film.words_per_pixel() - 1] = std::int64_t{3} << 40;
  film.words.back() = -4096;  // Of a filter with negative parts; there is nothing to divide by.
  CHECK(film.rows().sub_sum_weights(0)[0] == std::ldexp(3, 28));
  CHECK(film.rows().sub_sum_weights(1)[0] == -1);
  CHECK(film.mean().at(0, 0, 0) == static_cast<float>(std::ldexp(4, -28)));
  CHECK(film.mean().at(1, 0, 0) == 0);
}

TEST_CASE("squares are divided by the weight of all samples") {
  FilmSums film(weighted(1, 1, {sub_sum_number, 4, 0}, true));
  film.samples = {4};
  for (int sub = 0; sub < sub_sum_number; ++sub) add_weight(film, 0, sub, 0.5);
  add_light(film, 0, sub_sum_number, 6);
  CHECK(film.mean_of_squares().data == std::vector<float>{3, 3, 3});
}

TEST_CASE("weights of two films add up, each by itself, to the last bit of its half") {
  FilmSums film(weighted(2, 2, {sub_sum_number, 4, 0}, true)), band(weighted(2, 1, {sub_sum_number, 4, 0}, true));
  const double most = std::ldexp(3, 18) - film_weight_unit;  // All 32 bits, a quarter of which are negative numbers.
  for (int sub = 0; sub < sub_sum_number; ++sub) {
    add_weight(film, 3, sub, most - sub);
    add_weight(band, 1, sub, sub);
    add_light(film, 3, sub, 1);
    add_light(band, 1, sub, 2);
  }
  film.add_words(1, band.words);
  CHECK(film.rows().sub_sum_weights(3) == SubSumWeights{most, most, most, most});
  CHECK(film.rows().sub_sum_weights(2) == SubSumWeights{});
  for (const auto& colour : film.rows().sub_sums(3)) CHECK(colour[2] == 3);
}

/// Noise in every pixel, the same with and without weights of 1.
FilmSums noisy_weights(bool has_weights, const SubSums& sums, int samples) {
  FilmShape shape = weighted(9, 7, sums);
  shape.has_weights = has_weights;
  FilmSums film(shape);
  std::fill(film.samples.begin(), film.samples.end(), samples);
  std::mt19937_64 random(3);
  for (std::size_t pixel = 0; pixel < film.samples.size(); ++pixel)
    for (int sample = 0; sample < samples; ++sample) {
      const int sub = sub_sum_of(sums, sample);
      add_light(film, pixel, sub, static_cast<double>(random() % 1024) / 64);
      if (has_weights) add_weight(film, pixel, sub, 1);
    }
  return film;
}

TEST_CASE("weights of 1 tell what a film without weights tells") {
  for (const SubSums& sums : {SubSums{sub_sum_number, 2, 3}, SubSums{sub_sum_number, 4, 0}})
    for (const int samples : {5, 32, 35}) {
      const FilmSums film = noisy_weights(true, sums, samples), plain = noisy_weights(false, sums, samples);
      const std::optional<ErrorEstimate> told = estimate_error(film), expected = estimate_error(plain);
      REQUIRE((told && expected));
      CHECK(told->rmse > 0);
      CHECK(told->rmse == expected->rmse);
      CHECK(told->rmse_low == expected->rmse_low);
      CHECK(told->rmse_high == expected->rmse_high);
      CHECK(told->relmse == expected->relmse);
      CHECK(film.mean().data == plain.mean().data);
      CHECK(standard_error(film).data == standard_error(plain).data);
    }
}

TEST_CASE("sub-sums and pixels without weight leave the told error a number") {
  for (const SubSums& sums : {SubSums{sub_sum_number, 2, 3}, SubSums{sub_sum_number, 4, 0}}) {
    FilmSums film = noisy_weights(true, sums, 32);
    const std::size_t step = film.words_per_pixel();
    for (const std::size_t pixel : {0U, 12U}) film.words[(pixel + 1) * step - 1] = 0;
    film.words[13 * step - 2] = 0;
    const std::optional<ErrorEstimate> told = estimate_error(film);
    REQUIRE(told);
    CHECK(told->rmse > 0);
    CHECK(told->rmse_low < told->rmse);
    CHECK(std::isfinite(told->rmse_high));
    const Image map = standard_error(film);
    CHECK(std::all_of(map.data.begin(), map.data.end(), [](float value) { return std::isfinite(value); }));
    CHECK(map.data[3 * 12] == 0);
  }
}

}  // namespace
}  // namespace strahl::test
