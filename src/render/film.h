// SPDX-License-Identifier: MIT
// The film on the host: sums that do not depend on how the samples are split (docs/decisions/0002-film.md).
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "image/image.h"
#include "render/film_rows.h"
#include "render/launch_plan.h"

namespace strahl {

/// Sub-sums of three channels a pixel: four, or one where nobody compares them; window coordinates.
struct FilmSums : FilmShape {
  std::vector<std::int64_t> words;  ///< height x width x words_per_pixel(): sums.count, or one more, x 3 x
                                    ///< words_per_sum(kind), as the kind has them; behind them the weights.
  std::vector<int> samples;         ///< height x width: how many samples a pixel has, from first_sample on.

  FilmSums() = default;
  /// holds_words: false where the words stay on the device (render/device_film.h).
  explicit FilmSums(const FilmShape& shape, bool holds_words = true);
  /// What rows [row, row + rows) lack of the samples below `end`: rectangles of pixels that are equally far.
  [[nodiscard]] std::vector<Launch> missing(int row, int rows, int end) const;
  /// Counts the samples that a launch has added to its pixels; rows are those of the window.
  void add_samples(const Launch& launch);
  /// Adds another film's words of rows [row, row + its height), for the samples that are counted already.
  void add_words(int row, const std::vector<std::int64_t>& band);
  [[nodiscard]] FilmRows rows() const { return rows(0, height); }
  /// count rows from `row` on; without words where the film holds none.
  [[nodiscard]] FilmRows rows(int row, int count) const;
  /// Of splats: what a pixel's sums are divided by, the mean over all pixels. Of other films 0.
  [[nodiscard]] double paths_a_pixel() const;
  [[nodiscard]] Image black() const;
  [[nodiscard]] Image mean() const;
  [[nodiscard]] Image mean_of_squares() const;
};

}  // namespace strahl
