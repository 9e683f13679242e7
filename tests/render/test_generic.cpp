// SPDX-License-Identifier: MIT
// The generic program, which holds every effect, gives every scene of the project bit for bit the picture and the AOVs
// of the program made for it.
#include <catch2/catch.hpp>

#include "render/pictures.h"

namespace strahl::test {
namespace {

TEST_CASE("every scene of the project") {
  require_pocl_and_rusticl();
  int scenes = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(scene_folder)) {
    if (entry.path().extension() != ".xml") continue;
    INFO(entry.path());
    ++scenes;
    Scene scene = small_scene(entry.path(), 32, 24, 4);
    const bool is_dark = entry.path().stem() == "mirror-box";
    if (is_dark) scene.integrator.max_depth = 100;
    RenderSettings generic = all_aovs();
    generic.generic = true;
    const RenderResult expected = render("pocl", scene, all_aovs());
    CHECK((lit_pixels(expected.color) > 0) == !is_dark);
    CHECK(same_bits(expected, render("pocl", scene, generic)));
  }
  CHECK(scenes >= 18);
}

}  // namespace
}  // namespace strahl::test
