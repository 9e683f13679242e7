// SPDX-License-Identifier: MIT
// Indices of refraction by name, all of them, against Mitsuba's (mitsuba_indices.csv, written by
// tests/acceptance/mitsuba_indices.py).
#include <catch2/catch.hpp>
#include <fstream>
#include <set>
#include <sstream>

#include "scene/readers/metals.h"
#include "scene/readers/refractive_indices.h"

using namespace strahl;

namespace {

struct Line {
  std::string what, name, value;
  Rgb rgb;
};

std::vector<Line> lines() {
  std::ifstream file(STRAHL_SOURCE_DIR "/tests/scene/mitsuba_indices.csv");
  std::string text;
  REQUIRE(std::getline(file, text));
  std::vector<Line> all;
  while (std::getline(file, text)) {
    std::istringstream fields(text);
    Line line;
    for (std::string* word : {&line.what, &line.name, &line.value}) REQUIRE(std::getline(fields, *word, ','));
    char comma = 0;
    REQUIRE(fields >> line.rgb.r >> comma >> line.rgb.g >> comma >> line.rgb.b);
    all.push_back(line);
  }
  return all;
}

std::set<std::string> names(const std::string& what) {
  std::set<std::string> found;
  for (const Line& line : lines())
    if (line.what == what) found.insert(line.name);
  return found;
}

}  // namespace

TEST_CASE("metals have Mitsuba's indices, every one of them") {
  for (const Line& line : lines()) {
    if (line.what != "metal") continue;
    INFO(line.name << ", " << line.value);
    const std::optional<MetalIndex> index = metal_index(line.name);
    REQUIRE(index);
    const Rgb found = line.value == "eta" ? index->eta.color : index->k.color;
    // Six digits.
    CHECK(found.r == Approx(line.rgb.r).epsilon(5e-6));
    CHECK(found.g == Approx(line.rgb.g).epsilon(5e-6));
    CHECK(found.b == Approx(line.rgb.b).epsilon(5e-6));
  }
  std::set<std::string> known = names("metal");
  CHECK(known.size() == 71);
  known.insert("none");
  const std::vector<std::string> ours = metal_names();
  CHECK(std::set<std::string>(ours.begin(), ours.end()) == known);
  CHECK(ours.size() == known.size());
  CHECK_FALSE(metal_index("cu"));
}

TEST_CASE("media have Mitsuba's indices, every one of them") {
  for (const Line& line : lines()) {
    if (line.what != "medium") continue;
    INFO(line.name);
    CHECK(refractive_index(line.name).value() == Approx(line.rgb.r).epsilon(1e-7));
  }
  const std::vector<std::string> ours = refractive_names();
  CHECK(std::set<std::string>(ours.begin(), ours.end()) == names("medium"));
  CHECK(ours.size() == 23);
}
