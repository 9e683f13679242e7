// SPDX-License-Identifier: MIT
// Error metrics; their formulas stand in metrics.h. relMSE with its 0.01: Rousselle, Knaus, Zwicker, "Adaptive Sampling
// and Reconstruction using Greedy Error Minimization", SIGGRAPH Asia 2011.
#include "image/metrics.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "errors.h"
#include "image/comparable.h"
#include "image/srgb.h"
#include "image/ssim.h"

namespace strahl {
namespace {

struct Entry {
  Metric metric;
  const char* name;
};
constexpr std::array<Entry, 8> entries{{{Metric::mse, "mse"},
                                        {Metric::rmse, "rmse"},
                                        {Metric::mae, "mae"},
                                        {Metric::relmse, "relmse"},
                                        {Metric::psnr, "psnr"},
                                        {Metric::ssim, "ssim"},
                                        {Metric::flip, "flip"},
                                        {Metric::hdrflip, "hdrflip"}}};

/// Mean of f(a, reference) over all pixels and colour channels; a sum a row keeps the rounding error small.
template <class F>
double mean(const Image& a, const Image& reference, F f) {
  const ComparedChannels channels = comparable_channels(a, reference);
  double sum = 0;
  for (int y = 0; y < a.height; ++y) {
    double row = 0;
    for (int x = 0; x < a.width; ++x) {
      for (std::size_t c = 0; c < channels.a.size(); ++c) {
        row += f(static_cast<double>(a.at(x, y, channels.a[c])),
                 static_cast<double>(reference.at(x, y, channels.reference[c])));
      }
    }
    sum += row;
  }
  return sum / (static_cast<double>(a.width) * a.height * static_cast<double>(channels.a.size()));
}

double squared_difference(double a, double b) { return (a - b) * (a - b); }

}  // namespace

Metric metric_from_name(const std::string& name) {
  std::string known;
  for (const Entry& entry : entries) {
    if (name == entry.name) return entry.metric;
    known += fmt::format("{}{}", known.empty() ? "" : ", ", entry.name);
  }
  throw UsageError(fmt::format("unknown metric \"{}\"; known are {}", name, known));
}

const char* metric_name(Metric metric) {
  return std::find_if(entries.begin(), entries.end(), [metric](const Entry& e) { return e.metric == metric; })->name;
}

const std::vector<Metric>& all_metrics() {
  static const std::vector<Metric> metrics = [] {
    std::vector<Metric> all;
    all.reserve(entries.size());
    for (const Entry& entry : entries) all.push_back(entry.metric);
    return all;
  }();
  return metrics;
}

bool more_is_better(Metric metric) { return metric == Metric::psnr || metric == Metric::ssim; }

bool is_seen(Metric metric) { return metric == Metric::flip || metric == Metric::hdrflip; }

double compare_images(const Image& a, const Image& reference, Metric metric, double pixels_per_degree) {
  switch (metric) {
    case Metric::mse:
      return mean(a, reference, squared_difference);
    case Metric::rmse:
      return std::sqrt(mean(a, reference, squared_difference));
    case Metric::mae:
      return mean(a, reference, [](double x, double y) { return std::fabs(x - y); });
    case Metric::relmse:
      return mean(a, reference, relative_square);
    case Metric::ssim:
      return mean_ssim(metric_map(a, reference, metric, pixels_per_degree));
    case Metric::flip:
    case Metric::hdrflip:
      return metric_map(a, reference, metric, pixels_per_degree).mean();
    case Metric::psnr:
      break;
  }
  const double mse =
      mean(a, reference, [](double x, double y) { return squared_difference(display_value(x), display_value(y)); });
  return mse == 0 ? std::numeric_limits<double>::infinity() : -10 * std::log10(mse);
}

}  // namespace strahl
