// SPDX-License-Identifier: MIT
// Values a pixel, and the pictures in false colour that are made of them.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "errors.h"
#include "image/hdr_flip.h"
#include "image/metrics.h"
#include "image/pictures.h"

using namespace strahl;
using namespace strahl::test;
using Catch::Matchers::Contains;

namespace {

Image grey(int width, int height, float value) { return picture(width, height, rgb, {value}); }

/// A dot of the other brightness in the middle of 33 x 33 pixels.
Image dot(float around, float middle) {
  Image image = grey(33, 33, around);
  for (int c = 0; c < 3; ++c) image.at(16, 16, c) = middle;
  return image;
}

double largest(const Channel& map) { return *std::max_element(map.values.begin(), map.values.end()); }

}  // namespace

TEST_CASE("the heat map grows lighter with the difference") {
  constexpr int steps = 1001;
  Image a = picture(steps, 1, rgb, {0});
  for (int x = 0; x < steps; ++x) a.at(x, 0, x % 3) = static_cast<float>(x) * -0.003F;
  const Image map = difference_heatmap(a, picture(steps, 1, rgb, {0}));
  CHECK(map.width == steps);
  CHECK(map.channels == rgb);
  CHECK(std::stod(map.metadata.at("largest difference")) == Approx(1).epsilon(1e-6));
  const auto lightness = [&map](int x) {  // CIE L* of linear RGB with the sRGB primaries.
    const double y = 0.2126 * static_cast<double>(map.at(x, 0, 0)) + 0.7152 * static_cast<double>(map.at(x, 0, 1)) +
                     0.0722 * static_cast<double>(map.at(x, 0, 2));
    return y > 216.0 / 24389 ? 116 * std::cbrt(y) - 16 : y * 24389 / 27;
  };
  CHECK(lightness(0) < 1);
  CHECK(lightness(steps - 1) > 97);
  int out_of_order = 0;
  double steepest = 0;
  for (int x = 1; x < steps; ++x) {
    out_of_order += lightness(x) <= lightness(x - 1);
    steepest = std::max(steepest, lightness(x) - lightness(x - 1));
  }
  CHECK(out_of_order == 0);
  CHECK(steepest * (steps - 1) < 200);  // No step of the map stands out: at most twice the mean slope.
}

TEST_CASE("the heat map of equal pictures is dark") {
  const Image a = picture(2, 2, rgb, {0.5F});
  const Image map = difference_heatmap(a, a);
  CHECK(map.metadata.at("largest difference") == "0");
  for (const float value : map.data) CHECK(value < 0.01F);
}

TEST_CASE("relative differences have one scale in all pictures") {
  Image a = picture(5, 1, rgb, {0});
  Image b = picture(5, 1, rgb, {100});
  const std::vector<double> relative{0, 1e-4, 1e-3, 0.03162278, 1};
  for (int x = 0; x < 5; ++x) {
    for (int c = 0; c < 3; ++c) a.at(x, 0, c) = static_cast<float>(100 * (1 + relative[static_cast<std::size_t>(x)]));
  }
  const Channel map = metric_map(a, b, Metric::relmse);
  for (std::size_t x = 0; x < 5; ++x) CHECK(std::sqrt(map.values[x]) == Approx(relative[x]).epsilon(0.02));
  CHECK(compare_images(a, b, Metric::relmse) == Approx(map.mean()));
  const Image shown = metric_heatmap(a, b, Metric::relmse);
  const auto red = [&shown](int x) { return shown.at(x, 0, 0); };
  CHECK(red(1) == red(0));
  CHECK(red(2) == Approx(red(0)).margin(0.01));
  CHECK(red(3) > red(2) + 0.1F);
  CHECK(red(4) > red(3) + 0.1F);
}

TEST_CASE("equal pictures are alike everywhere") {
  const Image a = picture(13, 12, rgb, {0.25F, 4, 0.5F, 0, 0.75F});
  CHECK(largest(metric_map(a, a, Metric::flip)) == 0);
  CHECK(largest(metric_map(a, a, Metric::hdrflip)) == 0);
  for (const double similarity : metric_map(a, a, Metric::ssim).values) CHECK(similarity == 1);
  CHECK(compare_images(a, a, Metric::ssim) == 1);
}

TEST_CASE("maps show where the difference is") {
  const Image a = dot(0.25F, 0.75F);
  const Image b = grey(33, 33, 0.25F);
  for (const Metric metric : {Metric::flip, Metric::hdrflip}) {
    const Channel map = metric_map(a, b, metric);
    CHECK(map.row(16)[16] == largest(map));
    CHECK(map.row(16)[16] > 0.05);
    CHECK(map.row(0)[0] == 0);
  }
  const Channel similarity = metric_map(a, b, Metric::ssim);
  CHECK(similarity.row(16)[16] < 0.5);
  CHECK(similarity.row(10)[16] == 1);  // The window ends five pixels off.
  CHECK(similarity.row(11)[16] < 1);
  CHECK_THROWS_AS(metric_map(a, b, Metric::psnr), UsageError);
}

TEST_CASE("from afar a dot is harder to see") {
  const Image a = dot(0.25F, 0.5F);
  const Image b = grey(33, 33, 0.25F);
  for (const Metric metric : {Metric::flip, Metric::hdrflip}) {
    const auto seen = [&](double pixels_per_degree) { return largest(metric_map(a, b, metric, pixels_per_degree)); };
    CHECK(seen(20) > seen(67));
    CHECK(seen(67) > seen(200));
    for (const double bad : {0.5, 1001.0, std::nan("")}) {
      CHECK_THROWS_AS(compare_images(a, b, metric, bad), UsageError);
    }
  }
}

TEST_CASE("what is brighter than a display differs only in hdrflip") {
  const Image a = dot(2, 8);
  const Image b = grey(33, 33, 2);
  CHECK(compare_images(a, b, Metric::flip) == 0);
  CHECK(largest(metric_map(a, b, Metric::hdrflip)) > 0.05);
}

TEST_CASE("exposures follow the reference's brightest and median pixels") {
  const auto channels = [](double most, double few) {
    Channel channel(5, 5);
    std::fill(channel.values.begin(), channel.values.end(), most);
    channel.values[7] = few;
    return RgbChannels{channel, channel, channel};
  };
  const Exposures flat = flip_exposures(channels(0.5, 0.5));
  CHECK(flat.first == flat.last);
  CHECK(flat.count == 2);
  const Exposures wide = flip_exposures(channels(0.5, 500));
  CHECK(wide.last == Approx(flat.last));
  CHECK(wide.last - wide.first == Approx(std::log2(1000)));
  CHECK(wide.count == 10);
  const Exposures black = flip_exposures(channels(0, 0));
  CHECK(std::isfinite(black.first));
  CHECK(black.first == black.last);
}

TEST_CASE("pictures too small or of odd channels are refused, and why") {
  const Image small = grey(11, 10, 0.5F);
  CHECK_THROWS_AS(compare_images(small, small, Metric::ssim), InputError);
  CHECK_THROWS_WITH(compare_images(small, small, Metric::ssim), Contains("11 x 11") && Contains("11 x 10"));
  CHECK(compare_images(small, small, Metric::flip) == 0);
  const Image two = picture(12, 12, {"R", "G"}, {0.5F});
  CHECK_THROWS_WITH(compare_images(two, two, Metric::flip), Contains("there are 2 channels"));
  CHECK_THROWS_AS(compare_images(two, two, Metric::hdrflip), InputError);
  CHECK(compare_images(two, two, Metric::ssim) == 1);
  const Image one = picture(1, 1, {"Y"}, {0.5F});
  for (const Metric metric : all_metrics()) CHECK(metric_obstacle(one, metric).empty() == (metric != Metric::ssim));
  CHECK(compare_images(one, one, Metric::flip) == 0);
}

TEST_CASE("heat maps of ssim and flip have a fixed scale") {
  const Image black = grey(16, 16, 0);
  const Image white = grey(16, 16, 1);
  const Image dark = metric_heatmap(black, black, Metric::flip);
  CHECK(dark.metadata.at("metric") == "flip");
  CHECK(dark.data.at(0) < 0.001F);
  CHECK(dark.data.at(2) > 0);  // magma and inferno begin with a trace of blue.
  for (const Metric metric : {Metric::ssim, Metric::flip}) {
    const Image bright = metric_heatmap(white, black, metric);
    const Image medium = metric_heatmap(grey(16, 16, 0.05F), black, metric);
    CHECK(bright.data.at(0) > 0.9F);
    CHECK(bright.data.at(1) > medium.data.at(1));
  }
}
