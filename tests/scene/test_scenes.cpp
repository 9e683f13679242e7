// SPDX-License-Identifier: MIT
// Every scene of the project loads without a warning, strictly.
#include <catch2/catch.hpp>
#include <filesystem>

#include "scene/loader.h"

using namespace strahl;

TEST_CASE("the project's scenes load without warnings") {
  int scenes = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(STRAHL_SOURCE_DIR "/scenes")) {
    if (entry.path().extension() != ".xml") continue;
    INFO(entry.path());
    LoadOptions options;
    options.strict = true;
    const LoadedScene loaded = load_scene(entry.path().string(), options);
    for (const Diagnostic& d : loaded.warnings) UNSCOPED_INFO(d.text());
    CHECK(loaded.warnings.empty());
    CHECK(!loaded.scene.shapes.empty());
    ++scenes;
  }
  CHECK(scenes >= 14);
}

TEST_CASE("-D changes the size of first-light") {
  const LoadedScene loaded = load_scene(STRAHL_SOURCE_DIR "/scenes/lecture/first-light.xml", {{{"res", "64"}}, false});
  CHECK(loaded.scene.film.width == 64);
  CHECK(loaded.scene.integrator.name == "emission");
  for (const Shape& shape : loaded.scene.shapes) CHECK(shape.radiance.has_value());
}
