// SPDX-License-Identifier: MIT
// The rows of src/kinds/shapes.def name what the kernels have, and every shape of the scene can be written in a file:
// a kind without its entry, its area or its reader is named here.
#include <catch2/catch.hpp>
#include <filesystem>
#include <set>

#include "kinds/entries.h"
#include "program/features.h"
#include "scene/loader.h"

namespace strahl {
namespace {

using Names = std::set<std::string>;

Names entries(const std::string& list) {
  const std::vector<std::string> names = list_entries(list);
  return {names.begin(), names.end()};
}

TEST_CASE("every row names kinds that the kernels have, and all of them") {
  Names kinds, areas;
#define SHAPE_KIND(S, kind, area) \
  kinds.insert(#kind);            \
  areas.insert(#area);
#include "kinds/shapes.def"
#undef SHAPE_KIND
  areas.erase("none");
  CHECK(kinds == entries("shapes"));
  CHECK(areas == entries("areas"));
}

TEST_CASE("every kind of shape stands in a scene of its folder") {
  Names kinds;
  std::set<std::size_t> alternatives;
  for (const auto& file : std::filesystem::directory_iterator(STRAHL_SOURCE_DIR "/scenes/shapes")) {
    if (file.path().extension() != ".xml") continue;
    for_each_shape(load_scene(file.path().string()).scene, [&](const Shape& shape) {
      kinds.insert(shape_kind(shape));
      alternatives.insert(shape.geometry.index());
    });
  }
  CHECK(kinds == entries("shapes"));
  // A cloud is spheres of one file, which no scene has use for.
  alternatives.insert(Geometry(SphereCloud{}).index());
  for (std::size_t i = 0; i < std::variant_size_v<Geometry>; ++i) {
    INFO("alternative " << i << " of Geometry");
    CHECK(alternatives.contains(i));
  }
}

}  // namespace
}  // namespace strahl
