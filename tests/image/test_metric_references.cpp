// SPDX-License-Identifier: MIT
// Metrics against what others' programs say of the same pictures: scikit-image 0.26.0 (mse, psnr, ssim, in double
// precision) and flip-evaluator 1.7 (flip, hdrflip, in single precision), printed by
// tests/acceptance/metrics_peers.py --print, which compares more pairs where those are installed.
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>

#include "image/metrics.h"

using namespace strahl;

namespace {

double ramp(int x, int y, int c) { return (3 * x + 5 * y + 11 * c) % 48 / 64.0; }
double speckle(int x, int y, int c) { return (7 * x * x + 13 * y * y + 5 * x * y + 17 * c) % 31 / 128.0; }

Image painted(const std::function<double(int, int, int)>& value) {
  Image image;
  image.width = 48;
  image.height = 32;
  image.data.resize(image.index(0, image.height, 0));
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      for (int c = 0; c < 3; ++c) image.at(x, y, c) = static_cast<float>(value(x, y, c));
    }
  }
  return image;
}

Image scaled(const std::function<double(int)>& factor, double noise) {
  return painted([&](int x, int y, int c) { return (ramp(x, y, c) + noise * speckle(x, y, c)) * factor(x); });
}

struct Expected {
  double mse, psnr, ssim, flip, hdrflip;
};

void check(const Image& a, const Image& reference, const Expected& expected) {
  CHECK(compare_images(a, reference, Metric::mse) == Approx(expected.mse).epsilon(1e-12));
  CHECK(compare_images(a, reference, Metric::psnr) == Approx(expected.psnr).epsilon(1e-12));
  CHECK(compare_images(a, reference, Metric::ssim) == Approx(expected.ssim).epsilon(1e-10));
  // FLIP takes a square root of the difference of slopes: single precision's rounding shows where there is none.
  CHECK(compare_images(a, reference, Metric::flip) == Approx(expected.flip).margin(1e-4));
  CHECK(compare_images(a, reference, Metric::hdrflip) == Approx(expected.hdrflip).margin(1e-4));
}

}  // namespace

TEST_CASE("noise") {
  const auto one = [](int) { return 1.0; };
  check(scaled(one, 1), scaled(one, 0),
        {0.018197470241122775, 17.61885997964289, 0.8794312475039825, 0.32335540652275085, 0.35462841391563416});
}

TEST_CASE("a shift by a pixel") {
  check(painted([](int x, int y, int c) { return ramp(x + 1, y, c); }), painted(ramp),
        {0.032958984375, 14.002281236595158, 0.562166328607914, 0.26313120126724243, 0.24822074174880981});
}

TEST_CASE("a high range of brightness") {
  const auto stops = [](int x) { return std::exp2(x % 7); };
  check(scaled(stops, 1), scaled(stops, 0),
        {12.913532508744133, 16.062828428010175, 0.721532815371976, 0.2702966332435608, 0.3142767548561096});
}

TEST_CASE("the dark") {
  const auto dim = [](int) { return 1.0 / 64; };
  check(scaled(dim, 1), scaled(dim, 0),
        {4.442741758086615e-06, 34.40844466921455, 0.9272046225118024, 0.08545168489217758, 0.3546283543109894});
}

TEST_CASE("two even greys") {
  check(painted([](int, int, int) { return 0.5; }), painted([](int, int, int) { return 0.25; }),
        {0.0625, 14.055374519481374, 0.9526044221361724, 0.4518831968307495, 0.14483538269996643});
}
