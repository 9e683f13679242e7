// SPDX-License-Identifier: MIT
// The difference between a picture and the limit of infinitely many samples, estimated from the spread of the film's
// sub-sums alone.
//
// The film keeps independent estimates of a pixel: two with sampler sobol, four with any other (film/sub_sums.h). Their
// variance estimates the squared error of their mean. For each pixel, the difference between the *realised* squared
// error and this estimate is a sum of products of two different estimates' deviations. Its variance needs second
// moments only, for any distribution of the samples, and products of independent differences estimate these
// (docs/decisions/0011-error.md).
#pragma once

#include <cstddef>
#include <memory>
#include <optional>

#include "image/image.h"

namespace strahl {

struct FilmRows;
struct FilmSums;
class ErrorLaw;

/// Of linear RGB, all pixels and channels, unclamped.
struct ErrorEstimate {
  double rmse = 0;
  double rmse_low = 0, rmse_high = 0;  ///< Holds this picture's true RMSE in 95 of 100 cases.
  double relmse = 0;                   ///< mean(squared error / (mean^2 + 0.01)).
};

/// Relative standard deviation of the squared error, as the interval tells it; and what rmse_high is over the RMSE with
/// such a deviation.
[[nodiscard]] double squared_spread(const ErrorEstimate& error);
[[nodiscard]] double relative_upper(double squared_spread);

// The rest asks a film, whose headers are not installed (render/film.h); RenderResult has what it tells.

/// Of a film whose rows come in parts.
class ErrorSums {
 public:
  /// Of the film its shape and numbers of samples are looked at, not its words.
  explicit ErrorSums(const FilmSums& film);
  ~ErrorSums();
  /// As ErrorLaw::add (render/error_law.h): rows from `first` on, behind the one above them.
  void add(const FilmRows& rows, int first);
  /// Of all rows; none where a pixel has fewer samples than there are sub-sums.
  [[nodiscard]] std::optional<ErrorEstimate> tell() const;
  /// Standard error of each channel of these rows into the pixels from `first` on; NaN where a pixel has too few
  /// samples.
  void put_standard_error(const FilmRows& rows, std::size_t first, Image& image) const;

 private:
  std::unique_ptr<ErrorLaw> law_;
  bool is_told_;
  double values_;
};

/// Both of a film that is here as a whole.
[[nodiscard]] std::optional<ErrorEstimate> estimate_error(const FilmSums& film);
[[nodiscard]] Image standard_error(const FilmSums& film);

}  // namespace strahl
