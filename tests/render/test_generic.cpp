// SPDX-License-Identifier: MIT
// The generic program, which holds every effect, gives every scene of the project bit for bit the picture and the AOVs
// of the program made for it: in the robust tier, and with STRAHL_ALL_TIERS in stable and double too, each with AOVs
// and without.
#include <catch2/catch.hpp>
#include <cstdlib>

#include "render/pictures.h"

namespace strahl::test {
namespace {

void hold(const std::filesystem::path& path, const RenderSettings& settings) {
  INFO(path << ", " << precision_name(settings.precision) << ", " << settings.aovs.size() << " AOVs");
  Scene scene = small_scene(path, 24, 24, 4);
  const bool is_dark = path.stem() == "mirror-box";
  if (is_dark) scene.integrator.max_depth = 100;
  RenderSettings generic = settings;
  generic.generic = true;
  const RenderResult expected = render("pocl", scene, settings);
  CHECK((lit_pixels(expected.color) > 0) == !is_dark);
  CHECK(same_bits(expected, render("pocl", scene, generic)));
}

TEST_CASE("every scene of the project") {
  require_pocl_and_rusticl();
  const bool all_tiers = std::getenv("STRAHL_ALL_TIERS") != nullptr;
  RenderSettings plain;
  int scenes = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(scene_folder)) {
    if (entry.path().extension() != ".xml") continue;
    ++scenes;
    hold(entry.path(), plain);
    if (!all_tiers) continue;
    hold(entry.path(), all_aovs());
    for (const Precision precision : {Precision::stable, Precision::fp64}) {
      plain.precision = precision;
      hold(entry.path(), plain);
      hold(entry.path(), all_aovs(precision));
    }
    plain.precision = Precision::robust;
  }
  CHECK(scenes >= 33);
}

TEST_CASE("values beside the picture") {
  require_pocl_and_rusticl();
  hold(scene_folder / "lecture/lit.xml", all_aovs());
}

}  // namespace
}  // namespace strahl::test
