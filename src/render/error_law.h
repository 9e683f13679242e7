// SPDX-License-Identifier: MIT
// The formulas behind error_estimate.h, one for each way in which a film keeps its sub-sums (cl/film/sub_sums.h).
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "packing/cl_layout.h"

namespace strahl {

struct FilmSums;

using Colour = std::array<double, layout::FILM_CHANNELS>;

/// One pixel: mean, and estimated squared error of the mean.
struct PixelError {
  Colour mean{};
  Colour squared{};
};

/// Sums over pixels and channels.
struct PictureError {
  double squared = 0;
  double relative = 0;  ///< Of squared / (mean^2 + 0.01).
  double variance = 0;  ///< Of the difference between the realised squared error and `squared`.
  double freedom = 1;   ///< Degrees of freedom of `variance`.

  void add(const PixelError& pixel);
};

/// Four independent sums; at least four samples of each pixel.
[[nodiscard]] PixelError pixel_error_of_turns(const FilmSums& film, std::size_t at);
[[nodiscard]] PictureError picture_error_of_turns(const FilmSums& film);

/// Two sequences, each in two sums; at least four samples of each pixel.
[[nodiscard]] PixelError pixel_error_of_sequences(const FilmSums& film, std::size_t at);
[[nodiscard]] PictureError picture_error_of_sequences(const FilmSums& film);

/// Splats: four independent replicates of the whole picture, whose pixels are not independent. sizes: paths of a pixel
/// on average, in each.
[[nodiscard]] std::vector<double> replicate_sizes(const FilmSums& film);
[[nodiscard]] PixelError pixel_error_of_replicates(const FilmSums& film, const std::vector<double>& sizes,
                                                   std::size_t at);
[[nodiscard]] PictureError picture_error_of_replicates(const FilmSums& film);

/// Degrees of freedom of a sum of squares of deviations, whose own squares add up to `squares`: F. E. Satterthwaite
/// 1946. Where few pixels are most of the noise, the variance is itself known from few.
[[nodiscard]] double satterthwaite(double sum, double squares);

}  // namespace strahl
