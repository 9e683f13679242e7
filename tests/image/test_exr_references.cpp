// SPDX-License-Identifier: MIT
// Reference pictures that other renderers wrote (ignis: PIZ; Embree's viewer). They lie beside the checkout in
// ../shared and are not part of it; without them the test counts as skipped.
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>

#include "image/image_io.h"
#include "image/metrics.h"
#include "support/needs.h"

namespace {
const strahl::test::Needs needs(STRAHL_SOURCE_DIR "/../shared/data/ignis");
}

using namespace strahl;

namespace {

const std::string data = STRAHL_SOURCE_DIR "/../shared/data/";

}  // namespace

TEST_CASE("ignis references") {
  for (const std::string name : {"point", "plane-d1", "plane-d6", "sphere-light"}) {
    INFO(name);
    const Image image = read_image(data + "ignis/evaluation/references/ref-" + name + "-4096.exr");
    CHECK(image.width == 256);
    CHECK(image.height == 256);
    REQUIRE(image.channels.size() >= 3);
    CHECK(std::vector<std::string>(image.channels.begin(), image.channels.begin() + 3) ==
          std::vector<std::string>{"R", "G", "B"});
    std::size_t lit = 0;
    for (int y = 0; y < 256; ++y) {
      for (int x = 0; x < 256; ++x) lit += image.at(x, y, 0) > 0;
    }
    CHECK(lit > 1000);
    CHECK(compare_images(image, image, Metric::mse) == 0);
  }
}

TEST_CASE("Embree's primitive ids: 22,914 hits") {
  for (const std::string name : {"triangle", "triangle_far"}) {
    INFO(name);
    const Image image = read_image(data + "embree/" + name + ".xml.embree_viewer_primID.exr");
    CHECK(image.width == 512);
    CHECK(image.height == 512);
    int hits = 0;
    for (int y = 0; y < 512; ++y) {
      for (int x = 0; x < 512; ++x) hits += image.at(x, y, 0) != 0 || image.at(x, y, 1) != 0 || image.at(x, y, 2) != 0;
    }
    CHECK(hits == 22914);
  }
}

TEST_CASE("every other reference is read and holds finite values") {
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(data + "embree")) {
    if (entry.path().extension() != ".exr") continue;
    INFO(entry.path());
    const Image image = read_image(entry.path().string());
    int invalid = 0;
    for (const float value : image.data) invalid += !std::isfinite(value);
    CHECK(invalid == 0);
    ++files;
  }
  CHECK(files == 15);
}
