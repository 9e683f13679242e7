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

namespace strahl {
namespace {

struct Entry {
  Metric metric;
  const char* name;
};
constexpr std::array<Entry, 5> entries{{{Metric::mse, "mse"},
                                        {Metric::rmse, "rmse"},
                                        {Metric::mae, "mae"},
                                        {Metric::relmse, "relmse"},
                                        {Metric::psnr, "psnr"}}};

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

double encoded(double linear) { return srgb_from_linear(std::clamp(linear, 0.0, 1.0)); }

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

double compare_images(const Image& a, const Image& reference, Metric metric) {
  switch (metric) {
    case Metric::mse:
      return mean(a, reference, squared_difference);
    case Metric::rmse:
      return std::sqrt(mean(a, reference, squared_difference));
    case Metric::mae:
      return mean(a, reference, [](double x, double y) { return std::fabs(x - y); });
    case Metric::relmse:
      return mean(a, reference, [](double x, double y) { return squared_difference(x, y) / (y * y + 1e-2); });
    case Metric::psnr:
      break;
  }
  const double mse = mean(a, reference, [](double x, double y) { return squared_difference(encoded(x), encoded(y)); });
  return mse == 0 ? std::numeric_limits<double>::infinity() : -10 * std::log10(mse);
}

}  // namespace strahl
