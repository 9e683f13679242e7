// SPDX-License-Identifier: MIT
#include "image/ssim.h"

#include <cmath>

#include "image/separable_filter.h"

namespace strahl {
namespace {

constexpr double sigma = 1.5;
constexpr int radius = ssim_window / 2;
constexpr double c1 = 0.01 * 0.01;  // K1 and K2 squared: the range of values is 1.
constexpr double c2 = 0.03 * 0.03;

std::vector<double> window() {
  std::vector<double> weights;
  double sum = 0;
  for (int i = -radius; i <= radius; ++i) {
    weights.push_back(std::exp(-0.5 * (i / sigma) * (i / sigma)));
    sum += weights.back();
  }
  for (double& weight : weights) weight /= sum;
  return weights;
}

Channel local_mean(const Channel& channel) {
  static const std::vector<double> weights = window();
  return filter_columns(filter_rows(channel, weights, Border::mirror), weights, Border::mirror);
}

Channel product(const Channel& a, const Channel& b) {
  Channel result(a.width, a.height);
  for (std::size_t i = 0; i < result.values.size(); ++i) result.values[i] = a.values[i] * b.values[i];
  return result;
}

}  // namespace

Channel ssim_map(const Channel& a, const Channel& b) {
  const Channel mean_a = local_mean(a);
  const Channel mean_b = local_mean(b);
  const Channel mean_aa = local_mean(product(a, a));
  const Channel mean_bb = local_mean(product(b, b));
  Channel map = local_mean(product(a, b));
  for (std::size_t i = 0; i < map.values.size(); ++i) {
    const double ma = mean_a.values[i];
    const double mb = mean_b.values[i];
    const double variances = (mean_aa.values[i] - ma * ma) + (mean_bb.values[i] - mb * mb);
    const double covariance = map.values[i] - ma * mb;
    map.values[i] = (2 * ma * mb + c1) * (2 * covariance + c2) / ((ma * ma + mb * mb + c1) * (variances + c2));
  }
  return map;
}

double mean_ssim(const Channel& map) {
  Channel whole(map.width - 2 * radius, map.height - 2 * radius);
  for (int y = 0; y < whole.height; ++y) {
    const double* source = map.row(y + radius) + radius;
    std::copy(source, source + whole.width, whole.row(y));
  }
  return whole.mean();
}

}  // namespace strahl
