// SPDX-License-Identifier: MIT
// Weight by weight over whole rows, in both directions, so that the compiler vectorises along x.
#include "image/separable_filter.h"

#include <algorithm>

namespace strahl {
namespace {

int radius_of(const std::vector<double>& weights) { return static_cast<int>(weights.size() / 2); }

/// The index inside of 0 ... size - 1 that stands for `index`.
int inside(int index, int size, Border border) {
  if (border == Border::repeat) return std::clamp(index, 0, size - 1);
  const int period = 2 * size;
  const int folded = (index % period + period) % period;
  return std::min(folded, period - 1 - folded);
}

void add_scaled(double* sum, const double* values, double weight, int count) {
  for (int i = 0; i < count; ++i) sum[i] += weight * values[i];
}

}  // namespace

Channel filter_rows(const Channel& channel, const std::vector<double>& weights, Border border) {
  const int radius = radius_of(weights);
  Channel result(channel.width, channel.height);
  std::vector<double> padded(static_cast<std::size_t>(channel.width) + weights.size() - 1);
  for (int y = 0; y < channel.height; ++y) {
    const double* row = channel.row(y);
    double* const middle = padded.data() + radius;
    std::copy(row, row + channel.width, middle);
    for (int i = 1; i <= radius; ++i) {
      middle[-i] = row[inside(-i, channel.width, border)];
      middle[channel.width - 1 + i] = row[inside(channel.width - 1 + i, channel.width, border)];
    }
    for (std::size_t k = 0; k < weights.size(); ++k) {
      add_scaled(result.row(y), padded.data() + k, weights[k], channel.width);
    }
  }
  return result;
}

Channel filter_columns(const Channel& channel, const std::vector<double>& weights, Border border) {
  const int radius = radius_of(weights);
  Channel result(channel.width, channel.height);
  for (int y = 0; y < channel.height; ++y) {
    for (std::size_t k = 0; k < weights.size(); ++k) {
      const int source = inside(y + static_cast<int>(k) - radius, channel.height, border);
      add_scaled(result.row(y), channel.row(source), weights[k], channel.width);
    }
  }
  return result;
}

}  // namespace strahl
