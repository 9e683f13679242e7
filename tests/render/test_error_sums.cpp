// SPDX-License-Identifier: MIT
// A film that is told of part by part tells the same picture, error and map of errors, bit for bit, as one that is
// there as a whole.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "packing/cl_layout.h"
#include "render/error_estimate.h"
#include "render/error_law.h"
#include "render/film.h"
#include "render/film_sum.h"

namespace strahl::test {
namespace {

constexpr int width = 13, height = 17, samples = 64;

/// Words as kernels could have written them, of an even picture with noise.
FilmSums noisy_film(FilmKind kind, SubSums sums, bool has_own = false) {
  FilmSums film({kind, width, height, sums, 0, 2, false, has_own});
  std::mt19937_64 random(5);
  const auto per_sum = words_per_sum(kind);
  for (std::size_t i = 0; i < film.words.size(); ++i) {
    const auto number = static_cast<std::int64_t>(random() % (1U << 28U)) + (1 << 28);
    const std::size_t in_pixel = i % film.words_per_pixel();
    if (in_pixel >= (kind == FilmKind::pixels ? 0 : film.words_of_sums()))
      film.words[i] = number << 2U | 1;  // Both words have two bits of the usual top, 5.
    else if (in_pixel % per_sum == per_sum / 2)
      film.words[i] = number;
  }
  std::fill(film.samples.begin(), film.samples.end(), samples);
  return film;
}

/// So many rows from `row` on, behind the one above them.
void add_rows(const FilmSums& film, int row, int count, ErrorSums& sums) {
  const int above = row > 0 ? 1 : 0;
  sums.add(film.rows(row - above, above + count), row);
}

void hold(const FilmSums& film) {
  const std::optional<ErrorEstimate> whole = estimate_error(film);
  REQUIRE(whole);
  CHECK(whole->rmse > 0);
  CHECK(whole->rmse_low < whole->rmse);
  for (const int most : {1, 2, 3, 5, height - 1, height}) {
    ErrorSums sums(film);
    Image map = film.black(), mean = film.black();
    for (int row = 0; row < height; row += most) {
      const int count = std::min(most, height - row);
      add_rows(film, row, count, sums);
      const FilmRows part = film.rows(row, count);
      const auto first = static_cast<std::size_t>(row) * width;
      sums.put_standard_error(part, first, map);
      part.put_mean(first, film.paths_a_pixel(), mean);
    }
    const std::optional<ErrorEstimate> told = sums.tell();
    REQUIRE(told);
    CHECK(told->rmse == whole->rmse);
    CHECK(told->rmse_low == whole->rmse_low);
    CHECK(told->rmse_high == whole->rmse_high);
    CHECK(told->relmse == whole->relmse);
    CHECK(map.data == standard_error(film).data);
    CHECK(mean.data == film.mean().data);
  }
}

/// As threads may take them.
void hold_in_any_order(const FilmSums& film) {
  const std::optional<ErrorEstimate> whole = estimate_error(film);
  ErrorSums sums(film);
  for (int row = (height - 1) / rows_per_band * rows_per_band; row >= 0; row -= rows_per_band)
    add_rows(film, row, std::min(rows_per_band, height - row), sums);
  const std::optional<ErrorEstimate> told = sums.tell();
  REQUIRE((whole && told));
  CHECK(told->rmse == whole->rmse);
  CHECK(told->rmse_low == whole->rmse_low);
  CHECK(told->rmse_high == whole->rmse_high);
  CHECK(told->relmse == whole->relmse);
}

TEST_CASE("bands may come in any order") {
  hold_in_any_order(noisy_film(FilmKind::pixels, {layout::FILM_SUBSUMS, 2, 4}));
  hold_in_any_order(noisy_film(FilmKind::pixels, {layout::FILM_SUBSUMS, 4, 0}));
  hold_in_any_order(noisy_film(FilmKind::splats, {layout::FILM_SUBSUMS, 4, 0}, true));
}

TEST_CASE("two sequences, in parts") { hold(noisy_film(FilmKind::pixels, {layout::FILM_SUBSUMS, 2, 4})); }
TEST_CASE("four sequences, in parts") { hold(noisy_film(FilmKind::pixels, {layout::FILM_SUBSUMS, 4, 0})); }
TEST_CASE("replicates of splats, in parts") {
  for (const bool has_own : {false, true}) {
    FilmSums film = noisy_film(FilmKind::splats, {layout::FILM_SUBSUMS, 4, 0}, has_own);
    for (std::size_t at = 0; at < film.samples.size(); ++at) film.samples[at] += static_cast<int>(at % 5);
    hold(film);
  }
}

TEST_CASE("a pixel's own light is a mean over its own samples") {
  FilmSums film({FilmKind::splats, 2, 1, {layout::FILM_SUBSUMS, 4, 0}, 0, 1, false, true});
  film.samples = {8, 4};
  const FilmBins one{FILM_USUAL_TOP, 1 << 20, 0};  // Bins begin at 2^-20.
  for (std::size_t at = 0; at < 2; ++at)
    for (int sub = 0; sub < layout::FILM_SUBSUMS; ++sub)
      for (int sample = 0; sample < film.samples[at] / layout::FILM_SUBSUMS; ++sample)
        film_add(&film.words[at * film.words_per_pixel() + film.words_of_sums() +
                             static_cast<std::size_t>(sub * layout::FILM_CHANNELS * layout::FILM_SUM_WORDS)],
                 one);
  CHECK(film.mean().data == std::vector<float>{1, 0, 0, 1, 0, 0});
  const std::optional<ErrorEstimate> told = estimate_error(film);
  REQUIRE(told);
  CHECK(told->rmse == 0);
}

TEST_CASE("two sequences that agree by chance do not say that there is no error") {
  FilmSums film({FilmKind::pixels, 1, 1, {layout::FILM_SUBSUMS, 2, 4}, 0, 1, false, false});
  film.samples = {samples};
  // Of 16 samples each; the first sequence has sums 0 and 2.
  const std::array<int, layout::FILM_SUBSUMS> hits{16, 8, 0, 8};
  for (std::size_t sub = 0; sub < hits.size(); ++sub)
    film_add(&film.words[sub * layout::FILM_CHANNELS * layout::FILM_SUM_WORDS], {FILM_USUAL_TOP, hits[sub] << 20, 0});
  const std::optional<ErrorEstimate> told = estimate_error(film);
  REQUIRE(told);
  CHECK(told->rmse == 0);
  CHECK(told->rmse_low == 0);
  CHECK(told->rmse_high > 0.1);
}

TEST_CASE("one pixel with too few samples, and nothing is told") {
  FilmSums film = noisy_film(FilmKind::pixels, {layout::FILM_SUBSUMS, 2, 4});
  film.samples[7] = layout::FILM_SUBSUMS - 1;
  CHECK_FALSE(estimate_error(film));
  const Image map = standard_error(film);
  for (std::size_t i = 0; i < map.data.size(); ++i) CHECK(std::isnan(map.data[i]) == (i / 3 == 7));
}

}  // namespace
}  // namespace strahl::test
