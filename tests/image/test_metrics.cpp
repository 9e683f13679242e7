// SPDX-License-Identifier: MIT
// Metrics against cases worked out by hand, and refusals.
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "errors.h"
#include "image/metrics.h"
#include "image/pictures.h"
#include "image/srgb.h"

using namespace strahl;
using namespace strahl::test;
using Catch::Matchers::Contains;

namespace {

double measure(const Image& a, const Image& b, Metric metric) { return compare_images(a, b, metric); }

}  // namespace

TEST_CASE("names lead to metrics and back") {
  CHECK(all_metrics().size() == 8);
  for (const Metric metric : all_metrics()) CHECK(metric_from_name(metric_name(metric)) == metric);
  CHECK_THROWS_AS(metric_from_name("lpips"), UsageError);
  CHECK_THROWS_WITH(metric_from_name("lpips"), Contains("mse, rmse, mae, relmse, psnr, ssim, flip, hdrflip"));
}

TEST_CASE("equal pictures") {
  const Image image = picture(3, 2, rgb, {0.25F, 4, -1});
  for (const Metric metric : {Metric::mse, Metric::rmse, Metric::mae, Metric::relmse}) {
    CHECK(measure(image, image, metric) == 0);
  }
  CHECK(measure(image, image, Metric::psnr) == std::numeric_limits<double>::infinity());
}

TEST_CASE("differences worked out by hand") {
  // Differences 1, -2, 3, 0, 0, 0 against references 2, 2, 2, 0, 0, 0; dyadic values: no rounding.
  const Image a = picture(2, 1, rgb, {3, 0, 5, 0, 0, 0});
  const Image b = picture(2, 1, rgb, {2, 2, 2, 0, 0, 0});
  CHECK(measure(a, b, Metric::mse) == 14.0 / 6);
  CHECK(measure(a, b, Metric::rmse) == std::sqrt(14.0 / 6));
  CHECK(measure(a, b, Metric::mae) == 1);
  CHECK(measure(a, b, Metric::relmse) == Approx(14 / 4.01 / 6).epsilon(1e-14));
  CHECK(measure(b, a, Metric::relmse) == Approx((1 / 9.01 + 4 / 0.01 + 9 / 25.01) / 6).epsilon(1e-14));
}

TEST_CASE("psnr is taken of encoded values in [0, 1]") {
  const Image black = picture(2, 2, {"Y"}, {0});
  CHECK(measure(picture(2, 2, {"Y"}, {1}), black, Metric::psnr) == Approx(0).margin(1e-12));
  CHECK(measure(picture(2, 2, {"Y"}, {9}), picture(2, 2, {"Y"}, {1}), Metric::psnr) ==
        std::numeric_limits<double>::infinity());
  const auto tenth = static_cast<float>(linear_from_srgb(0.1));
  CHECK(measure(picture(2, 2, {"Y"}, {tenth}), black, Metric::psnr) == Approx(20).epsilon(1e-7));
}

TEST_CASE("alpha and further layers are not compared, the order of channels does not matter") {
  const Image a = picture(1, 1, {"R", "G", "B", "A"}, {1, 2, 3, 0.5F});
  const Image b = picture(1, 1, {"A", "R", "G", "B", "normal.X"}, {1, 1, 2, 3, 7});
  CHECK(measure(a, b, Metric::mse) == 0);
}

TEST_CASE("what cannot be compared is refused with the place") {
  const Image a = picture(4, 2, rgb, {0.5F});
  CHECK_THROWS_AS(measure(a, picture(2, 4, rgb, {0.5F}), Metric::mse), InputError);
  CHECK_THROWS_WITH(measure(a, picture(2, 4, rgb, {0.5F}), Metric::mse), Contains("4 x 2") && Contains("2 x 4"));
  CHECK_THROWS_WITH(measure(a, picture(4, 2, {"Y"}, {0.5F}), Metric::psnr), Contains("R G B") && Contains("Y"));
  for (const float bad : {std::nanf(""), std::numeric_limits<float>::infinity()}) {
    Image b = a;
    b.at(3, 1, 2) = bad;
    CHECK_THROWS_WITH(measure(a, b, Metric::mae), Contains("the reference") && Contains("pixel 3,1 in channel B"));
    CHECK_THROWS_WITH(measure(b, a, Metric::mae), Contains("the picture holds"));
    CHECK_THROWS_AS(difference_heatmap(a, b), InputError);
  }
  for (const Metric metric : all_metrics()) {
    INFO(metric_name(metric));
    const Image large = picture(16, 16, rgb, {0.5F}), alpha = picture(16, 16, {"A"}, {0.5F});
    const auto refuse = [&](const Image& one, const Image& other, const std::string& words) {
      CHECK_THROWS_AS(measure(one, other, metric), InputError);
      CHECK_THROWS_WITH(measure(one, other, metric), Contains(words));
    };
    refuse(alpha, alpha, is_seen(metric) ? "there are 0 channels" : "no colour channels to compare: A");
    refuse(large, alpha, "no colour channels to compare: A");
    Image cut = large;
    cut.data.pop_back();
    refuse(large, cut, "the reference has 16 x 16 pixels with 3 channels, which are 768 values, and holds 767");
    refuse(cut, large, "the picture has 16 x 16 pixels");
    if (metric != Metric::ssim) refuse(picture(0, 0, rgb, {1}), picture(0, 0, rgb, {1}), "0 x 0 pixels");
  }
}
