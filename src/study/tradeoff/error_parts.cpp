// SPDX-License-Identifier: MIT
#include "study/tradeoff/error_parts.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "image/comparable.h"

namespace strahl {
namespace {

constexpr double normal_975 = 1.959964;  ///< The 97.5 % quantile of the normal distribution.

/// Mean and squared distances from it of a few numbers, two passes.
struct Spread {
  double mean = 0;
  double squares = 0;
};

Spread spread(const std::vector<double>& values) {
  Spread result;
  for (const double value : values) result.mean += value;
  result.mean /= static_cast<double>(values.size());
  for (const double value : values) result.squares += (value - result.mean) * (value - result.mean);
  return result;
}

}  // namespace

double ErrorParts::rmse() const { return std::sqrt(mse); }
double ErrorParts::rmse_low() const { return std::sqrt(std::max(0.0, mse - normal_975 * mse_error)); }
double ErrorParts::rmse_high() const { return std::sqrt(mse + normal_975 * mse_error); }

ErrorParts error_parts(const std::vector<Image>& pictures, const Image& reference, double reference_variance) {
  if (pictures.size() < 2) throw std::logic_error("variance over seeds needs two pictures at the least");
  std::vector<ComparedChannels> channels;
  for (const Image& picture : pictures) channels.push_back(comparable_channels(picture, reference));
  const std::size_t colours = channels.front().a.size();
  const double seeds = static_cast<double>(pictures.size());
  const double pixels = static_cast<double>(reference.width) * reference.height;

  ErrorParts parts;
  double bias2 = 0, bias2_squares = 0;
  std::vector<double> values(pictures.size()), errors(pictures.size());
  for (int y = 0; y < reference.height; ++y)
    for (int x = 0; x < reference.width; ++x) {
      std::fill(errors.begin(), errors.end(), 0.0);
      double pixel_bias2 = 0;
      for (std::size_t c = 0; c < colours; ++c) {
        const double truth = static_cast<double>(reference.at(x, y, channels.front().reference[c]));
        for (std::size_t k = 0; k < pictures.size(); ++k) {
          values[k] = static_cast<double>(pictures[k].at(x, y, channels[k].a[c]));
          errors[k] += (values[k] - truth) * (values[k] - truth) / static_cast<double>(colours);
        }
        const Spread of_value = spread(values);
        const double variance = of_value.squares / (seeds - 1);
        parts.variance += variance / static_cast<double>(colours);
        pixel_bias2 +=
            ((of_value.mean - truth) * (of_value.mean - truth) - variance / seeds) / static_cast<double>(colours);
      }
      const Spread of_error = spread(errors);
      parts.mse += of_error.mean;
      parts.mse_error += of_error.squares / (seeds - 1) / seeds;
      bias2 += pixel_bias2;
      bias2_squares += pixel_bias2 * pixel_bias2;
    }
  parts.mse /= pixels;
  parts.mse_error = std::sqrt(parts.mse_error) / pixels;
  parts.variance /= pixels;
  bias2 /= pixels;
  parts.bias2_error = std::sqrt(std::max(0.0, bias2_squares / pixels - bias2 * bias2) / pixels);
  parts.bias2 = std::max(0.0, bias2 - reference_variance);
  return parts;
}

}  // namespace strahl
