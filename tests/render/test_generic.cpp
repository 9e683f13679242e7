// SPDX-License-Identifier: MIT
// The generic program, which holds every effect, gives every scene of the project bit for bit the picture and the AOVs
// of the program made for it: in the stable tier, one scene of each folder in robust, whose programs take longest to
// build; with STRAHL_ALL_TIERS all of them in stable, robust and double, each with AOVs and without.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <set>
#include <vector>

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

std::vector<std::filesystem::path> every_scene() {
  std::vector<std::filesystem::path> scenes;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(scene_folder))
    if (entry.path().extension() == ".xml") scenes.push_back(entry.path());
  std::sort(scenes.begin(), scenes.end());
  return scenes;
}

void hold(const std::filesystem::path& path, Precision precision, bool is_with_aovs) {
  RenderSettings plain;
  plain.precision = precision;
  hold(path, plain);
  if (is_with_aovs) hold(path, all_aovs(precision));
}

TEST_CASE("every scene of the project") {
  require_pocl_and_rusticl();
  const bool all = std::getenv("STRAHL_ALL_TIERS") != nullptr;
  const std::vector<std::filesystem::path> scenes = every_scene();
  CHECK(scenes.size() >= 33);
  std::set<std::filesystem::path> folders;
  for (const std::filesystem::path& scene : scenes) {
    const bool is_first = folders.insert(scene.parent_path()).second;
    hold(scene, Precision::stable, all);
    if (all || is_first) hold(scene, Precision::robust, all);
    if (all) hold(scene, Precision::fp64, all);
  }
}

TEST_CASE("values beside the picture") {
  require_pocl_and_rusticl();
  hold(scene_folder / "lecture/lit.xml", all_aovs());
}

}  // namespace
}  // namespace strahl::test
