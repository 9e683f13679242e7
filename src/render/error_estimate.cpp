// SPDX-License-Identifier: MIT
#include "render/error_estimate.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "render/error_law.h"
#include "render/film.h"

namespace strahl {
namespace {

constexpr double normal_quantile = 1.959964;  ///< Two-sided 95 %.

/// Two-sided 95 % of Student's distribution: expansion about the normal's, Abramowitz and Stegun 1964, 26.7.5.
double quantile(double degrees_of_freedom) {
  constexpr double z = normal_quantile;
  const double per = 1 / std::max(degrees_of_freedom, 2.0);
  return z + (z * z * z + z) / 4 * per + (5 * std::pow(z, 5) + 16 * z * z * z + 3 * z) / 96 * per * per +
         (3 * std::pow(z, 7) + 19 * std::pow(z, 5) + 17 * z * z * z - 15 * z) / 384 * per * per * per;
}

/// Half-width of the squared error's interval, relative to it, from which on the RMSE's begins at 0.
constexpr double widest = 2;

struct Interval {
  double low, high;
};

/// Of the RMSE, whose square is known to half_width. The realised squared error over the estimated one is distributed
/// as a ratio of two sums of squares, F, which reaches further up than down. An interval about the squared error is too
/// wide below and too narrow above; one about its root fits (docs/decisions/0011-error.md). Beyond `widest` the upper
/// end goes on as the root, also where the estimate is 0 by chance.
Interval interval_of(double rmse, double half_width) {
  const double mse = rmse * rmse;
  if (half_width < widest * mse) return {rmse - half_width / (2 * rmse), rmse + half_width / (2 * rmse)};
  return {0, std::sqrt(widest * half_width)};
}

bool is_told(const FilmShape& film, int samples) { return std::min(samples, film.sums.count) >= layout::FILM_SUBSUMS; }

bool is_told(const FilmSums& film) {
  return std::all_of(film.samples.begin(), film.samples.end(), [&](int samples) { return is_told(film, samples); });
}

std::unique_ptr<ErrorLaw> law_of(const FilmSums& film) {
  if (film.kind == FilmKind::splats) return law_of_replicates(film);
  if (film.sums.sequences == layout::SOBOL_SEQUENCES) return law_of_sequences(film);
  return law_of_turns(film);
}

}  // namespace

double squared_spread(const ErrorEstimate& error) {
  if (!(error.rmse > 0)) return 0;
  const double high = error.rmse_high / error.rmse;
  return (error.rmse_low > 0 ? 2 * (high - 1) : high * high / widest) / normal_quantile;
}

double relative_upper(double squared_spread) { return interval_of(1, normal_quantile * squared_spread).high; }

void PictureError::add(const PixelError& pixel) {
  for (int c = 0; c < layout::FILM_CHANNELS; ++c) {
    squared += pixel.squared[c];
    relative += pixel.squared[c] / (pixel.mean[c] * pixel.mean[c] + 0.01);
  }
}

void PictureError::operator+=(const PictureError& other) {
  squared += other.squared;
  relative += other.relative;
  variance += other.variance;
}

double satterthwaite(double sum, double squares) { return squares > 0 ? 2 * sum * sum / squares : 1; }

ErrorSums::ErrorSums(const FilmSums& film)
    : law_(law_of(film)),
      is_told_(is_told(film)),
      values_(static_cast<double>(film.samples.size() * layout::FILM_CHANNELS)) {}

ErrorSums::~ErrorSums() = default;

void ErrorSums::add(const FilmRows& rows, int first) {
  if (is_told_) law_->add(rows, first);
}

std::optional<ErrorEstimate> ErrorSums::tell() const {
  if (!is_told_) return std::nullopt;
  const PictureError picture = law_->tell();
  const double rmse = std::sqrt(picture.squared / values_);
  const double half_width = quantile(picture.freedom) * std::sqrt(picture.variance) / values_;
  const auto [low, high] = interval_of(rmse, half_width);
  return ErrorEstimate{rmse, low, high, picture.relative / values_};
}

void ErrorSums::put_standard_error(const FilmRows& rows, std::size_t first, Image& image) const {
  float* out = image.data.data() + first * layout::FILM_CHANNELS;
  for (std::size_t at = 0; at < rows.samples.size(); ++at) {
    Colour squared;
    squared.fill(std::numeric_limits<double>::quiet_NaN());
    if (is_told(rows, rows.samples[at])) squared = law_->pixel_error(rows, at).squared;
    for (const double value : squared) *out++ = static_cast<float>(std::sqrt(value));
  }
}

std::optional<ErrorEstimate> estimate_error(const FilmSums& film) {
  ErrorSums sums(film);
  sums.add(film.rows(), 0);
  return sums.tell();
}

Image standard_error(const FilmSums& film) {
  Image image = film.black();
  ErrorSums(film).put_standard_error(film.rows(), 0, image);
  return image;
}

}  // namespace strahl
