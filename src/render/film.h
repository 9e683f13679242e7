// SPDX-License-Identifier: MIT
// The film on the host: sums that do not depend on how the samples are split (docs/decisions/0002-film.md).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "image/image.h"
#include "render/launch_plan.h"
#include "render/sub_sums.h"

namespace strahl {

/// How samples reach the film.
enum class FilmKind {
  pixels,  ///< Each into its own pixel: sums of cl/film/film_sum.h.
  splats   ///< Light paths, each into any pixels: sums of cl/film/splat.h. The samples of a pixel are its paths.
};

/// Words of a channel's sum.
[[nodiscard]] std::size_t words_per_sum(FilmKind kind);

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

  [[nodiscard]] std::size_t words_per_pixel() const;
};

/// Sub-sums of three channels a pixel: four, or one where nobody compares them; window coordinates.
struct FilmSums : FilmShape {
  std::vector<std::int64_t> words;  ///< height x width x words_per_pixel(): sums.count, or one more, x 3 x
                                    ///< words_per_sum(kind), as the kind has them.
  std::vector<int> samples;         ///< height x width: how many samples a pixel has, from first_sample on.

  FilmSums() = default;
  /// holds_words: false where the words stay on the device (put_mean).
  explicit FilmSums(const FilmShape& shape, bool holds_words = true);
  /// What rows [row, row + rows) lack of the samples below `end`: rectangles of pixels that are equally far.
  [[nodiscard]] std::vector<Launch> missing(int row, int rows, int end) const;
  /// Counts the samples that a launch has added to its pixels; rows are those of the window.
  void add_samples(const Launch& launch);
  /// Adds another film's words of rows [row, row + its height), for the samples that are counted already.
  void add_words(int row, const std::vector<std::int64_t>& band);
  /// The sum of the samples of a pixel in one sub-sum, in radiance. pixel: index along the window's rows.
  [[nodiscard]] double sub_sum(std::size_t pixel, int sub, int channel) const;
  /// The number of those samples.
  [[nodiscard]] int sub_sum_samples(std::size_t pixel, int sub) const;
  /// Of splats: what a pixel's sums are divided by, the mean over all pixels. Of other films 0.
  [[nodiscard]] double paths_a_pixel() const;
  /// Mean over all samples; it does not depend on their sub-sums. A pixel without samples is black.
  [[nodiscard]] Image mean() const;
  [[nodiscard]] Image black() const;
  /// The mean of the pixels from `first` on into their places. part: the words of them; paths: paths_a_pixel(), which
  /// looks at all pixels, and there may be many parts.
  void put_mean(std::span<const std::int64_t> part, std::size_t first, double paths, Image& image) const;
  /// The same of the squares, where the film has them.
  void put_squares(std::span<const std::int64_t> part, std::size_t first, Image& image) const;
  [[nodiscard]] Image mean_of_squares() const;

 private:
  /// All sub-sums of a channel together, `sum` being the first one's words.
  [[nodiscard]] double total(const std::int64_t* sum) const;
};

}  // namespace strahl
