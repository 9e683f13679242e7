// SPDX-License-Identifier: MIT
// The bill in words, and what is said of pixels brighter than white.
#include <catch2/catch.hpp>
#include <chrono>
#include <cmath>

#include "cli/summary.h"

namespace strahl::cli {
namespace {

/// 100 pixels of one grey.
Image grey(float value) {
  Image image;
  image.width = image.height = 10;
  image.data.assign(300, value);
  return image;
}

void set(Image& image, int x, int y, float value) {
  for (int c = 0; c < 3; ++c) image.at(x, y, c) = value;
}

RunStats stats() {
  RunStats run;
  run.device = "0:0 device";
  run.spp = run.least_spp = run.most_spp = 16;
  run.seconds.total = 10;
  run.seconds.kernel = 9;
  run.seconds.program = 0.9;
  run.seconds.load = 0.001;
  run.error = ErrorBudget{{0.01, 0.009, 0.011, 0.1}, 0.001, 1.2, std::nullopt};
  return run;
}

TEST_CASE("a line each: what was made, time, error, what is clipped") {
  CHECK(bill(stats(), {"a.png", 300, 200, true, false, 8, {0.023, std::nullopt}}) ==
        "a.png 300×200 · 16 spp · 0:0 device\n"
        "  time     10.00 s: program 0.90, kernel 9.00, other 0.10\n"
        "  error    RMSE 0.01 (95 %: 0.0091 to 0.011): noise 0.01, 8-bit output 0.001, float rounding not measured (-v "
        "does)\n"
        "           half the noise: 37.00 s at the most\n"
        "  clipped  2.3 % of the pixels are brighter than white, which is no part of the error");
  CHECK(brief_bill(stats(), {"a.png", 300, 200, true, false, 8, {}}) ==
        "a.png · 10.00 s · 16 spp · RMSE 0.01 (0.0091 to 0.011)");
}

TEST_CASE("what is not known is not said") {
  RunStats run = stats();
  run.error.reset();
  run.least_spp = 3;
  run.camera_rays = 8000;
  const std::string text = bill(run, {"", 10, 100, false, false, 0, {}});
  CHECK(text.find("10×100 · 16 spp · 0:0 device · interrupted after 50 % of the samples\n") == 0);
  run.resumed_samples = 4000;
  CHECK(bill(run, {"", 10, 100, false, false, 0, {}}).find("interrupted after 75 % of the samples\n") !=
        std::string::npos);
  // Of a time or an error no number of samples is the whole.
  CHECK(bill(run, {"", 10, 100, false, true, 0, {}}).find("10×100 · 3 to 16 spp · 0:0 device · interrupted\n") == 0);
  CHECK(brief_bill(run, {"", 10, 100, false, true, 0, {}}) == "10.00 s · 3 to 16 spp · interrupted");
  RunStats last = stats();
  last.camera_rays = last.resumed_samples = 1000;
  CHECK(bill(last, {"", 10, 100, true, false, 0, {}}).find("half the noise: 64.00 s") != std::string::npos);
  CHECK(text.find("error    not measured") != std::string::npos);
  CHECK(text.find("clipped") == std::string::npos);
}

TEST_CASE("lamps that are not above white themselves, however dim, excuse no overexposed picture") {
  CHECK(clipping_of(grey(4), 0, {{0.2, 0.2, 0.2}}).stops == -2);
  CHECK(clipping_of(grey(4), 0, {{1, 1, 1}}).stops == -2);
  CHECK_FALSE(clipping_of(grey(4), 0, {{0.2, 0.2, 0.2}, {4, 4, 4}}).stops);
  CHECK(clipping_of(grey(4), -1, {{1.9, 1.9, 1.9}}).stops == -2);  // White is 2.
}

// Each pixel against each lamp and each neighbour would take minutes.
TEST_CASE("many lamps cost no time") {
  Image wall = grey(3);
  wall.width = wall.height = 700;
  wall.data.assign(static_cast<std::size_t>(700) * 700 * 3, 3.0F);
  std::vector<Rgb> lamps;
  for (int i = 0; i < 10000; ++i) lamps.push_back({4.0 + 0.01 * i, 5.0, 100.0 - 0.005 * i});
  const auto start = std::chrono::steady_clock::now();
  CHECK(clipping_of(wall, 0, lamps).stops == -2);
  lamps.assign(10000, {4, 5, 6});
  CHECK(clipping_of(wall, 0, lamps).stops == -2);
  CHECK(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() < 20);
}

TEST_CASE("an overexposed picture gets the exposure that shows it, a lamp in sight none") {
  const std::vector<Rgb> lamps{{8, 8, 8}};
  const Clipping bright = clipping_of(grey(3), 0, lamps);
  CHECK(bright.share == 1);
  CHECK(bright.stops == -2);
  CHECK_FALSE(clipping_of(grey(3), -2, lamps).stops);
  CHECK(clipping_of(grey(3), -2, lamps).share == 0);

  Image room = grey(0.5F);
  for (int x = 2; x <= 7; ++x)
    for (int y = 2; y <= 7; ++y) set(room, x, y, 4);  // The lamp's edge, as wide as the default filter.
  for (int x = 4; x <= 5; ++x)
    for (int y = 4; y <= 5; ++y) set(room, x, y, 8.5F);
  CHECK(clipping_of(room, 0, lamps).share == Approx(0.36));
  CHECK_FALSE(clipping_of(room, 0, lamps).stops);
  CHECK(clipping_of(room, 0, {}).stops == -4);
  CHECK(clipping_text(clipping_of(room, 0, {})).find("--exposure -4 shows them") != std::string::npos);

  Image glint = grey(0.5F);
  set(glint, 0, 0, 100);  // One pixel in a hundred may stay.
  CHECK_FALSE(clipping_of(glint, 0, lamps).stops);
  CHECK(clipping_of(glint, 0, lamps).share == Approx(0.01));
  CHECK(clipping_text(clipping_of(grey(1), 0, lamps)).empty());
}

}  // namespace
}  // namespace strahl::cli
