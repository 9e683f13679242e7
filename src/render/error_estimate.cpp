// SPDX-License-Identifier: MIT
#include "render/error_estimate.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "render/error_law.h"
#include "render/film.h"

namespace strahl {
namespace {

/// Two-sided 95 % of Student's distribution: expansion about the normal's, Abramowitz and Stegun 1964, 26.7.5.
double quantile(double degrees_of_freedom) {
  constexpr double z = 1.959964;
  const double per = 1 / std::max(degrees_of_freedom, 2.0);
  return z + (z * z * z + z) / 4 * per + (5 * std::pow(z, 5) + 16 * z * z * z + 3 * z) / 96 * per * per;
}

bool is_told(const FilmSums& film, std::size_t at) {
  return std::min(film.samples[at], film.sums.count) >= layout::FILM_SUBSUMS;
}

bool is_of_two_sequences(const FilmSums& film) { return film.sums.sequences == layout::SOBOL_SEQUENCES; }

}  // namespace

void PictureError::add(const PixelError& pixel) {
  for (int c = 0; c < layout::FILM_CHANNELS; ++c) {
    squared += pixel.squared[c];
    relative += pixel.squared[c] / (pixel.mean[c] * pixel.mean[c] + 0.01);
  }
}

double satterthwaite(double sum, double squares) { return squares > 0 ? 2 * sum * sum / squares : 1; }

std::optional<ErrorEstimate> estimate_error(const FilmSums& film) {
  for (std::size_t at = 0; at < film.samples.size(); ++at)
    if (!is_told(film, at)) return std::nullopt;
  const PictureError picture = film.kind == FilmKind::splats ? picture_error_of_replicates(film)
                               : is_of_two_sequences(film)   ? picture_error_of_sequences(film)
                                                             : picture_error_of_turns(film);
  const double values = static_cast<double>(film.samples.size() * layout::FILM_CHANNELS);
  const double mse = picture.squared / values;
  const double half_width = quantile(picture.freedom) * std::sqrt(picture.variance) / values;
  return ErrorEstimate{std::sqrt(mse), std::sqrt(std::max(0.0, mse - half_width)), std::sqrt(mse + half_width),
                       picture.relative / values};
}

Image standard_error(const FilmSums& film) {
  Image image;
  image.width = film.width;
  image.height = film.height;
  image.data.reserve(film.samples.size() * layout::FILM_CHANNELS);
  const std::vector<double> sizes = film.kind == FilmKind::splats ? replicate_sizes(film) : std::vector<double>{};
  for (std::size_t at = 0; at < film.samples.size(); ++at) {
    if (!is_told(film, at)) {
      image.data.insert(image.data.end(), layout::FILM_CHANNELS, std::numeric_limits<float>::quiet_NaN());
      continue;
    }
    const PixelError pixel = film.kind == FilmKind::splats ? pixel_error_of_replicates(film, sizes, at)
                             : is_of_two_sequences(film)   ? pixel_error_of_sequences(film, at)
                                                           : pixel_error_of_turns(film, at);
    for (const double squared : pixel.squared) image.data.push_back(static_cast<float>(std::sqrt(squared)));
  }
  return image;
}

}  // namespace strahl
