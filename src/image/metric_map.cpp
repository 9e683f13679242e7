// SPDX-License-Identifier: MIT
// Metrics that have a value a pixel.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "errors.h"
#include "image/colour_channels.h"
#include "image/comparable.h"
#include "image/hdr_flip.h"
#include "image/metrics.h"
#include "image/srgb.h"
#include "image/ssim.h"

namespace strahl {
namespace {

/// The colour channels of both pictures, each value through f.
struct ChannelPairs {
  std::vector<Channel> a, reference;
};

template <class F>
ChannelPairs channel_pairs(const Image& a, const Image& reference, F f) {
  const auto of = [&f](const Image& image, const std::vector<int>& indices) {
    std::vector<Channel> channels;
    for (const int index : indices) {
      channels.push_back(channel_of(image, index));
      for (double& value : channels.back().values) value = f(value);
    }
    return channels;
  };
  const ComparedChannels indices = comparable_channels(a, reference);
  return {of(a, indices.a), of(reference, indices.reference)};
}

/// The mean of one map a channel.
Channel mean_map(std::vector<Channel> maps) {
  Channel mean = std::move(maps.front());
  for (std::size_t c = 1; c < maps.size(); ++c) {
    for (std::size_t i = 0; i < mean.values.size(); ++i) mean.values[i] += maps[c].values[i];
  }
  for (double& value : mean.values) value /= static_cast<double>(maps.size());
  return mean;
}

/// Mean over channels of f(a, reference).
template <class F>
Channel linear_map(const Image& a, const Image& reference, F f) {
  ChannelPairs channels = channel_pairs(a, reference, [](double value) { return value; });
  for (std::size_t c = 0; c < channels.a.size(); ++c) {
    std::vector<double>& values = channels.a[c].values;
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = f(values[i], channels.reference[c].values[i]);
  }
  return mean_map(std::move(channels.a));
}

Channel similarity_map(const Image& a, const Image& reference) {
  const ChannelPairs channels = channel_pairs(a, reference, display_value);
  std::vector<Channel> maps;
  for (std::size_t c = 0; c < channels.a.size(); ++c) maps.push_back(ssim_map(channels.a[c], channels.reference[c]));
  return mean_map(std::move(maps));
}

RgbChannels rgb(std::vector<Channel>&& channels) {
  if (channels.size() == 1) return {channels[0], channels[0], channels[0]};
  return {std::move(channels[0]), std::move(channels[1]), std::move(channels[2])};
}

Channel seen_map(const Image& a, const Image& reference, Metric metric, double pixels_per_degree) {
  if (!(pixels_per_degree >= 1 && pixels_per_degree <= 1000)) {
    throw UsageError(fmt::format("{} pixels per degree: 1 to 1000 are possible", pixels_per_degree));
  }
  const double top = metric == Metric::flip ? 1 : std::numeric_limits<double>::infinity();
  ChannelPairs channels = channel_pairs(a, reference, [top](double value) { return std::clamp(value, 0.0, top); });
  const auto map = metric == Metric::flip ? flip_map : hdr_flip_map;
  return map(rgb(std::move(channels.a)), rgb(std::move(channels.reference)), pixels_per_degree);
}

bool has_map(Metric metric) {
  return metric == Metric::mae || metric == Metric::relmse || metric == Metric::ssim || is_seen(metric);
}

}  // namespace

void require_map(Metric metric) {
  if (has_map(metric)) return;
  std::string mapped;
  for (const Metric other : all_metrics())
    if (has_map(other)) mapped += fmt::format("{}{}", mapped.empty() ? "" : ", ", metric_name(other));
  throw UsageError(fmt::format("{} has no value a pixel; these have: {}", metric_name(metric), mapped));
}

double relative_square(double a, double reference) {
  return (a - reference) * (a - reference) / (reference * reference + 1e-2);
}

std::string metric_obstacle(const Image& image, Metric metric) {
  if (metric == Metric::ssim && (image.width < ssim_window || image.height < ssim_window)) {
    return fmt::format("ssim's window needs {0} x {0} pixels, there are {1} x {2}", ssim_window, image.width,
                       image.height);
  }
  const std::size_t channels = colour_channels(image).size();
  if (is_seen(metric) && channels != 1 && channels != 3) {
    return fmt::format("{} needs R, G and B or one channel of grey, there are {} channels", metric_name(metric),
                       channels);
  }
  return {};
}

Channel metric_map(const Image& a, const Image& reference, Metric metric, double pixels_per_degree) {
  require_map(metric);
  const std::string obstacle = metric_obstacle(a, metric);
  if (!obstacle.empty()) throw InputError(obstacle);
  if (metric == Metric::mae) return linear_map(a, reference, [](double x, double y) { return std::fabs(x - y); });
  if (metric == Metric::relmse) return linear_map(a, reference, relative_square);
  if (metric == Metric::ssim) return similarity_map(a, reference);
  return seen_map(a, reference, metric, pixels_per_degree);
}

}  // namespace strahl
