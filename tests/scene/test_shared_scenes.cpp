// SPDX-License-Identifier: MIT
// Other people's scenes (../shared) load with the expected warnings and nothing else. Exits 77 where they are absent.
#include <catch2/catch.hpp>
#include <filesystem>
#include <map>

#include "scene/loader.h"
#include "support/needs.h"

namespace {
const strahl::test::Needs needs(STRAHL_SOURCE_DIR "/../shared/data");
}

using namespace strahl;

namespace {

const std::string shared = STRAHL_SOURCE_DIR "/../shared/data/";

/// Shapes, and how often each phrase occurs in the warnings; every warning must match one.
struct Expected {
  std::size_t shapes;
  std::map<std::string, int> warnings;
};

void check_scene(const std::string& path, const Expected& expected) {
  INFO(path);
  const LoadedScene loaded = load_scene(shared + path);
  CHECK(loaded.scene.shapes.size() == expected.shapes);
  int matched = 0;
  for (const auto& [phrase, count] : expected.warnings) {
    int found = 0;
    for (const Diagnostic& d : loaded.warnings) found += d.message.find(phrase) != std::string::npos ? 1 : 0;
    INFO(phrase);
    CHECK(found == count);
    matched += found;
  }
  for (const Diagnostic& d : loaded.warnings) UNSCOPED_INFO(d.text());
  CHECK(matched == static_cast<int>(loaded.warnings.size()));
  for (const Diagnostic& d : loaded.warnings) CHECK((d.where.line > 0 && d.where.column > 0));
}

}  // namespace

TEST_CASE("ignis") {
  check_scene("ignis/evaluation/point.xml", {1, {}});
  check_scene("ignis/evaluation/plane.xml", {1, {}});
  check_scene("ignis/evaluation/sphere-light.xml", {2, {}});
}

TEST_CASE("sionna") {
  const char *no_sensor = "no <sensor>", *itu = "unknown bsdf \"itu-radio-material\"";
  check_scene("sionna/box/box.xml", {1, {{itu, 1}, {no_sensor, 1}}});
  check_scene("sionna/box_one_screen/box_one_screen.xml", {2, {{itu, 2}, {no_sensor, 1}}});
  check_scene("sionna/double_reflector/double_reflector.xml", {2, {{no_sensor, 1}}});
  check_scene("sionna/floor_wall/floor_wall.xml", {2, {}});
  check_scene("sionna/simple_reflector/simple_reflector.xml", {1, {{itu, 1}, {no_sensor, 1}}});
  check_scene("sionna/simple_street_canyon/simple_street_canyon.xml", {7, {{no_sensor, 1}}});
  check_scene("sionna/simple_street_canyon_with_cars/simple_street_canyon_with_cars.xml", {15, {{no_sensor, 1}}});
  check_scene("sionna/simple_wedge/simple_wedge.xml", {1, {{no_sensor, 1}}});
  check_scene("sionna/triple_reflector/triple_reflector.xml", {3, {{no_sensor, 1}}});
}
