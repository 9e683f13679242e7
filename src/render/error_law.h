// SPDX-License-Identifier: MIT
// The formulas behind error_estimate.h, one for each way in which a film keeps its sub-sums (cl/film/sub_sums.h).
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>

#include "packing/cl_layout.h"
#include "render/film_rows.h"

namespace strahl {

struct FilmSums;

using Colour = std::array<double, layout::FILM_CHANNELS>;

/// What follows from the weights of a pixel's sub-sums. Where each sample counts 1, nearly all pixels have the same,
/// and to divide for each takes long.
template <class Value>
class OfSamples {
 public:
  [[nodiscard]] const Value& of(const FilmRows& rows, std::size_t at) {
    if (!value_ || rows.has_weights || rows.samples[at] != samples_) value_.emplace(rows.sub_sum_weights(at));
    samples_ = rows.samples[at];
    return *value_;
  }

 private:
  int samples_ = 0;
  std::optional<Value> value_;
};
using WeightsOfSamples = OfSamples<SubSumWeights>;

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
  void operator+=(const PictureError& other);
};

/// Rows that are added up by themselves. So the sums of a picture do not depend on who adds which of its rows.
constexpr int rows_per_band = 4;
[[nodiscard]] inline std::size_t band_of(int row) { return static_cast<std::size_t>(row / rows_per_band); }

/// use(at, x, band) for each pixel of rows as ErrorLaw::add has them; at: index within the rows; band: none in the row
/// above the first.
template <class Use>
void each_pixel(const FilmRows& rows, int first, const Use& use) {
  const auto width = static_cast<std::size_t>(rows.width);
  std::size_t at = 0;
  for (int y = first - (first > 0 ? 1 : 0); at < rows.samples.size(); ++y) {
    const std::optional<std::size_t> band = y < first ? std::nullopt : std::optional(band_of(y));
    for (std::size_t x = 0; x < width; ++x, ++at) use(at, x, band);
  }
}

/// Adds up a picture whose rows come in parts: a film may lie on the device, and only a part of it here. Every pixel
/// has at least four samples.
class ErrorLaw {
 public:
  ErrorLaw() = default;
  ErrorLaw(const ErrorLaw&) = delete;
  ErrorLaw& operator=(const ErrorLaw&) = delete;
  virtual ~ErrorLaw() = default;
  /// Rows of the picture from `first` on; where that is not its first row, the one above them comes before them, which
  /// is only looked at. Threads may add rows of different bands at the same time; those of a band come from the top
  /// down.
  virtual void add(const FilmRows& rows, int first) = 0;
  /// at: index within the rows.
  [[nodiscard]] virtual PixelError pixel_error(const FilmRows& rows, std::size_t at) const = 0;
  [[nodiscard]] virtual PictureError tell() const = 0;
};

// Pixels that share samples have correlated noise: the covariance of two pixels' products is the squared covariance of
// their noise. So the variance is larger than that of independent pixels: shared_noise.h has from the picture how much,
// film.noise_overlap is the most.

/// Four independent sums.
[[nodiscard]] std::unique_ptr<ErrorLaw> law_of_turns(const FilmShape& film);
/// Two sequences, each in two sums.
[[nodiscard]] std::unique_ptr<ErrorLaw> law_of_sequences(const FilmShape& film);
/// Splats: four independent replicates of the whole picture, whose pixels are not independent. Of the film only the
/// numbers of samples are looked at.
[[nodiscard]] std::unique_ptr<ErrorLaw> law_of_replicates(const FilmSums& film);

/// Degrees of freedom of a sum of squares of deviations, whose own squares add up to `squares`: F. E. Satterthwaite
/// 1946. Where few pixels are most of the noise, the variance is itself known from few.
[[nodiscard]] double satterthwaite(double sum, double squares);

}  // namespace strahl
