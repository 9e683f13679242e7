// SPDX-License-Identifier: MIT
#include "render/error_estimate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "packing/cl_layout.h"
#include "render/film.h"

namespace strahl {
namespace {

constexpr int sub_sums = layout::FILM_SUBSUMS;
constexpr int channels = layout::FILM_CHANNELS;
static_assert(sub_sums == 4, "disjoint_pairs are those of four");
constexpr int disjoint_pairs[3][4] = {{0, 1, 2, 3}, {0, 2, 1, 3}, {0, 3, 1, 2}};

/// Two-sided 95 % of Student's distribution: expansion about the normal's, Abramowitz and Stegun 1964, 26.7.5.
double quantile(double degrees_of_freedom) {
  constexpr double z = 1.959964;
  const double per = 1 / std::max(degrees_of_freedom, 2.0);
  return z + (z * z * z + z) / 4 * per + (5 * std::pow(z, 5) + 16 * z * z * z + 3 * z) / 96 * per * per;
}

using Colour = std::array<double, channels>;

/// One pixel: mean, estimated squared error of the mean, and the variance of what the latter's sum over the channels
/// differs from the realised one by.
struct PixelError {
  Colour mean{};
  Colour squared{};
  double difference_variance = 0;
};

PixelError pixel_error(const FilmSums& film, std::size_t at) {
  const int samples = film.samples[at];
  std::array<Colour, sub_sums> part{};
  std::array<double, sub_sums> count{};
  PixelError pixel;
  for (int k = 0; k < sub_sums; ++k) {
    count[k] = (samples - k + sub_sums - 1) / sub_sums;
    for (int c = 0; c < channels; ++c) {
      const double sum = film.sub_sum(at, k, c);
      part[k][c] = sum / count[k];
      pixel.mean[c] += sum / samples;
    }
  }
  for (int c = 0; c < channels; ++c) {
    double spread = 0;
    for (int k = 0; k < sub_sums; ++k) spread += count[k] * (part[k][c] - pixel.mean[c]) * (part[k][c] - pixel.mean[c]);
    pixel.squared[c] = spread / ((sub_sums - 1) * static_cast<double>(samples));
  }
  // Of one sample: sum over pairs of channels of the squared covariance.
  double covariance = 0;
  for (const auto& pairs : disjoint_pairs) {
    double product = 0;
    for (int c = 0; c < channels; ++c)
      product += (part[pairs[0]][c] - part[pairs[1]][c]) * (part[pairs[2]][c] - part[pairs[3]][c]);
    covariance += product * product /
                  ((1 / count[pairs[0]] + 1 / count[pairs[1]]) * (1 / count[pairs[2]] + 1 / count[pairs[3]])) / 3;
  }
  pixel.difference_variance = 2.0 * sub_sums / ((sub_sums - 1) * static_cast<double>(samples) * samples) * covariance;
  return pixel;
}

}  // namespace

std::optional<ErrorEstimate> estimate_error(const FilmSums& film) {
  if (film.sub_sums < sub_sums) return std::nullopt;
  double squared = 0, relative = 0, variance = 0, variance_squared = 0;
  for (std::size_t at = 0; at < film.samples.size(); ++at) {
    if (film.samples[at] < sub_sums) return std::nullopt;
    const PixelError pixel = pixel_error(film, at);
    for (int c = 0; c < channels; ++c) {
      squared += pixel.squared[c];
      relative += pixel.squared[c] / (pixel.mean[c] * pixel.mean[c] + 0.01);
    }
    variance += pixel.difference_variance;
    variance_squared += pixel.difference_variance * pixel.difference_variance;
  }
  const double values = static_cast<double>(film.samples.size()) * channels;
  const double mse = squared / values;
  // Where few pixels are most of the noise, the variance is itself known from few: Satterthwaite 1946.
  const double freedom = variance_squared > 0 ? 2 * variance * variance / variance_squared : 1;
  const double half_width = quantile(freedom) * std::sqrt(variance) / values;
  return ErrorEstimate{std::sqrt(mse), std::sqrt(std::max(0.0, mse - half_width)), std::sqrt(mse + half_width),
                       relative / values};
}

Image standard_error(const FilmSums& film) {
  Image image;
  image.width = film.width;
  image.height = film.height;
  image.data.reserve(film.samples.size() * channels);
  for (std::size_t at = 0; at < film.samples.size(); ++at) {
    if (std::min(film.samples[at], film.sub_sums) < sub_sums) {
      image.data.insert(image.data.end(), channels, std::numeric_limits<float>::quiet_NaN());
    } else {
      for (const double squared : pixel_error(film, at).squared)
        image.data.push_back(static_cast<float>(std::sqrt(squared)));
    }
  }
  return image;
}

}  // namespace strahl
