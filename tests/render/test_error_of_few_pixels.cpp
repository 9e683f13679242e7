// SPDX-License-Identifier: MIT
// The told interval where one pixel or a few are all of a picture's noise: `--pixel`, crops of two pixels, a small
// window of noise in a quiet picture. Films are made of known normal noise, so that the realised error is known.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <vector>

#include "packing/cl_layout.h"
#include "render/error_estimate.h"
#include "render/film.h"
#include "render/film_sum.h"

namespace strahl::test {
namespace {

constexpr int spp = 64, parts = layout::FILM_SUBSUMS;
constexpr double light = 8;  ///< So that no sum is negative.

struct Noise {
  int width, height;
  int pixels;  ///< That have noise of deviation 1 in each sub-sum's mean; the others have `rest`.
  double rest;
};

/// Grey noise, whose channels say nothing more than one. Returns the picture's true RMSE.
double fill(const Noise& noise, std::mt19937_64& random, FilmSums& film) {
  std::normal_distribution<double> normal;
  std::fill(film.words.begin(), film.words.end(), 0);
  double squares = 0;
  for (int at = 0; at < noise.width * noise.height; ++at) {
    // Five apart, so that they are not neighbours.
    const bool is_noisy = at % 5 == 0 && at / 5 < noise.pixels;
    double error = 0;
    for (int sub = 0; sub < parts; ++sub) {
      const double off = normal(random) * (is_noisy ? 1 : noise.rest);
      error += off / parts;
      const double sum = (light + off) * spp / parts;
      for (int channel = 0; channel < layout::FILM_CHANNELS; ++channel) {
        const std::size_t word =
            static_cast<std::size_t>(at) * film.words_per_pixel() +
            static_cast<std::size_t>(sub * layout::FILM_CHANNELS + channel) * layout::FILM_SUM_WORDS;
        film_add(&film.words[word], {FILM_USUAL_TOP, std::llround(std::ldexp(sum, 20)), 0});
      }
    }
    squares += error * error;
  }
  return std::sqrt(squares / (noise.width * noise.height));
}

struct Told {
  double within = 0;      ///< Share of pictures whose true error is within what is told.
  double half_width = 0;  ///< Relative, the median.
};

Told told_of(const Noise& noise, const SubSums& sums, int pictures = 1000) {
  FilmSums film({FilmKind::pixels, noise.width, noise.height, sums, 0, 1, false, false});
  std::fill(film.samples.begin(), film.samples.end(), spp);
  std::mt19937_64 random(7);
  int within = 0;
  std::vector<double> widths;
  for (int i = 0; i < pictures; ++i) {
    const double rmse = fill(noise, random, film);
    const std::optional<ErrorEstimate> told = estimate_error(film);
    REQUIRE(told);
    within += rmse >= told->rmse_low && rmse <= told->rmse_high ? 1 : 0;
    widths.push_back((told->rmse_high - told->rmse_low) / (2 * told->rmse));
  }
  std::nth_element(widths.begin(), widths.begin() + pictures / 2, widths.end());
  return {static_cast<double>(within) / pictures, widths[pictures / 2]};
}

TEST_CASE("few noisy pixels: the interval holds") {
  for (const SubSums& sums : {SubSums{parts, 2, 4}, SubSums{parts, 4, 0}})
    for (const Noise& noise :
         {Noise{1, 1, 1, 0}, Noise{2, 1, 1, 1}, Noise{2, 2, 1, 1}, Noise{16, 16, 1, 1e-3}, Noise{16, 16, 1, 0},
          Noise{16, 16, 2, 1e-3}, Noise{16, 16, 4, 1e-3}, Noise{16, 16, 9, 1e-3}, Noise{16, 16, 16, 1e-3},
          Noise{16, 16, 30, 1e-3}, Noise{16, 16, 0, 1}, Noise{4, 4, 0, 1}, Noise{2, 2, 0, 1}}) {
      INFO(sums.sequences << " sequences, " << noise.width << " x " << noise.height << ", " << noise.pixels
                          << " noisy beside " << noise.rest);
      CHECK(told_of(noise, sums).within > 0.93);
    }
}

/// An interval about the squared error is a fifth wider; one whose quantile is the variance's own, a twenty-fifth.
TEST_CASE("few noisy pixels: the interval of two sequences is no wider than it has to be") {
  CHECK(told_of({16, 16, 16, 1e-3}, {parts, 2, 4}, 10000).half_width < 0.65);
}

}  // namespace
}  // namespace strahl::test
