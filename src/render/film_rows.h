// SPDX-License-Identifier: MIT
// Rows of a film as they are looked at, wherever their words lie: the means of their pixels, and what they say of the
// error.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "image/image.h"
#include "packing/cl_layout.h"
#include "render/sub_sums.h"

namespace strahl {

/// How samples reach the film.
enum class FilmKind {
  pixels,  ///< Each into its own pixel: sums of cl/film/film_sum.h.
  splats   ///< Light paths, each into any pixels: sums of cl/film/splat.h. The samples of a pixel are its paths.
};

/// Words of a channel's sum.
[[nodiscard]] std::size_t words_per_sum(FilmKind kind);

/// What weights of samples are counted in: the kernel rounds them to it (cl/film/shared_samples_lanes.h).
constexpr double film_weight_unit = 1.0 / (1 << layout::WEIGHT_BITS);

/// What films have to agree in to be of one picture.
struct FilmShape {
  FilmKind kind = FilmKind::pixels;
  int width = 0;
  int height = 0;
  SubSums sums;          ///< Which sample is in which.
  int first_sample = 0;  ///< The number of each pixel's first sample; others only in a part (RenderGoal).
  double unit = 1;       ///< Radiance that corresponds to 1 in the kernels.
  /// One sum more behind a pixel's sub-sums (cl/film/moments.h). Not of splats.
  bool has_squares = false;
  /// Of splats: as many sums of FilmKind::pixels behind them, of the light that each pixel's own camera paths bring.
  bool has_own = false;
  /// Samples count in every pixel that the filter reaches: the sums are of weighted samples. A pixel's words end with
  /// its sub-sums' weights, in film_weight_unit: one signed word for the only sub-sum; of several, two halves a word
  /// that add up, the low one first. Negative sums are those of filters with negative parts. Not of splats.
  bool has_weights = false;
  /// The sum, over all pixels, of the squared correlation of their noise with one pixel's: 1 where pixels share no
  /// samples (packing/filter_overlap.h).
  double noise_overlap = 1;
  bool are_counts_weights = false;  ///< Of a black film, on which the end is measured as if it had samples.

  [[nodiscard]] std::size_t words_per_pixel() const;
  /// Of a pixel's weights, its last words.
  [[nodiscard]] std::size_t words_of_weights() const;
  /// Of a pixel's sub-sums, behind which the other sums are.
  [[nodiscard]] std::size_t words_of_sums() const;
};

using SubSumColours = std::array<std::array<double, layout::FILM_CHANNELS>, layout::FILM_SUBSUMS>;
using SubSumWeights = std::array<double, layout::FILM_SUBSUMS>;

/// `height` rows. Shapes of words and samples as in FilmSums.
struct FilmRows : FilmShape {
  std::span<const std::int64_t> words;
  std::span<const int> samples;

  /// Without the first row.
  [[nodiscard]] FilmRows below_first() const;
  /// The sum of the samples of a pixel in each of FILM_SUBSUMS sub-sums, in radiance; of splats without its own. pixel:
  /// index along these rows.
  [[nodiscard]] SubSumColours sub_sums(std::size_t pixel) const;
  /// The same of its own camera paths; 0 where has_own is not set.
  [[nodiscard]] double own_sum(std::size_t pixel, int sub, int channel) const;
  /// The weights of those samples; without has_weights each sample counts 1.
  [[nodiscard]] SubSumWeights sub_sum_weights(std::size_t pixel) const;
  /// The mean over all samples, which does not depend on their sub-sums, into the image from its pixel `first` on. A
  /// pixel without samples, or whose samples weigh nothing, stays black, or has what light paths brought. paths:
  /// FilmSums::paths_a_pixel(), which looks at all pixels.
  void put_mean(std::size_t first, double paths, Image& image) const;
  /// The same of the squares, where the film has them.
  void put_squares(std::size_t first, Image& image) const;

 private:
  using Totals = std::array<double, layout::FILM_CHANNELS>;
  /// The weight of all samples of a pixel.
  [[nodiscard]] double total_weight(std::size_t pixel) const;
  /// All sub-sums together, whose words begin at `first`: of light paths, and of samples.
  [[nodiscard]] Totals splats_of(const std::int64_t* first) const;
  [[nodiscard]] Totals samples_of(const std::int64_t* pixel) const;
};

}  // namespace strahl
