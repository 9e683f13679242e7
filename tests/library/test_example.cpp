// SPDX-License-Identifier: MIT
// The pictures that install_example left behind: those of docs/example and of the installed program.
#include <catch2/catch.hpp>

#include "image/image_io.h"
#include "scene/model/vec.h"

using namespace strahl;

namespace {

Image picture(const std::string& name) { return read_image(STRAHL_INSTALL_TEST "/elsewhere/" + name); }

Rgb pixel(const Image& image, int x, int y) { return {image.at(x, y, 0), image.at(x, y, 1), image.at(x, y, 2)}; }

/// As near as 8 bits allow.
void check_color(const Rgb& seen, const Rgb& emitted) {
  CHECK(seen.r == Approx(emitted.r).margin(0.01));
  CHECK(seen.g == Approx(emitted.g).margin(0.01));
  CHECK(seen.b == Approx(emitted.b).margin(0.01));
}

}  // namespace

TEST_CASE("The example's picture shows its marbles, its floor and its sky") {
  const Image marbles = picture("marbles.png");
  REQUIRE(marbles.width == 640);
  REQUIRE(marbles.height == 480);
  check_color(pixel(marbles, 320, 240), {0.95, 0.32, 0.16});
  check_color(pixel(marbles, 320, 10), {0.50, 0.68, 0.88});
  check_color(pixel(marbles, 320, 470), {0.16, 0.19, 0.27});
  check_color(pixel(marbles, 100, 270), {0.10, 0.52, 0.85});  // left of the view's axis
  check_color(pixel(marbles, 530, 270), {0.98, 0.76, 0.18});
}

TEST_CASE("The installed program finds its kernels wherever it runs") {
  const Image wall = picture("wall.png");
  REQUIRE(wall.width == 64);
  REQUIRE(wall.height == 64);
  check_color(pixel(wall, 32, 32), {0.95, 0.32, 0.16});
}
