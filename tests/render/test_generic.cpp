// SPDX-License-Identifier: MIT
// The generic program, which holds every effect, gives every scene of the project bit for bit the picture and the AOVs
// of the program made for it: in the robust tier scenes that together call for nearly every effect; with
// STRAHL_ALL_TIERS all scenes, in stable and double too, each with AOVs and without, and by the generic program that
// follows samples one by one.
#include <algorithm>
#include <catch2/catch.hpp>
#include <map>
#include <set>
#include <vector>

#include "program/features.h"
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
  if (!is_of_all_tiers()) return;
  RenderSettings one_by_one = generic;
  one_by_one.paths_in_lanes = false;
  CHECK(same_bits(expected, render("pocl", scene, one_by_one)));
}

std::set<std::string> effects(const std::filesystem::path& path) {
  std::set<std::string> on;
  for (const FeatureReport& row : features_of(load_scene(path.string()).scene, {}).report)
    if (row.on) on.insert(row.name);
  return on;
}

std::vector<std::filesystem::path> every_scene() {
  std::vector<std::filesystem::path> scenes;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(scene_folder))
    if (entry.path().extension() == ".xml") scenes.push_back(entry.path());
  std::sort(scenes.begin(), scenes.end());
  return scenes;
}

/// Few scenes that together call for nearly every effect that one of them calls for: next comes the scene with the most
/// new effects. Those that add a single one are left to the run of all scenes, for each is a program to compile.
std::vector<std::filesystem::path> cover(const std::vector<std::filesystem::path>& scenes) {
  std::map<std::filesystem::path, std::set<std::string>> left;
  for (const auto& path : scenes) left[path] = effects(path);
  std::vector<std::filesystem::path> chosen;
  for (;;) {
    const auto most = std::max_element(left.begin(), left.end(),
                                       [](const auto& a, const auto& b) { return a.second.size() < b.second.size(); });
    if (most->second.size() < 2) return chosen;
    chosen.push_back(most->first);
    const std::set<std::string> covered = most->second;
    for (auto& [path, names] : left)
      std::erase_if(names, [&](const std::string& name) { return covered.contains(name); });
  }
}

void hold(const std::filesystem::path& path, Precision precision, bool is_with_aovs) {
  RenderSettings plain;
  plain.precision = precision;
  hold(path, plain);
  if (is_with_aovs) hold(path, all_aovs(precision));
}

TEST_CASE("every scene of the project") {
  require_pocl();
  const bool all = is_of_all_tiers();
  const std::vector<std::filesystem::path> scenes = every_scene();
  CHECK(scenes.size() >= 58);
  for (const std::filesystem::path& scene : all ? scenes : cover(scenes)) {
    hold(scene, Precision::robust, all);
    if (!all) continue;
    hold(scene, Precision::stable, true);
    hold(scene, Precision::fp64, true);
  }
}

TEST_CASE("values beside the picture") {
  require_pocl();
  hold(scene_folder / "lecture/lit.xml", all_aovs());
}

}  // namespace
}  // namespace strahl::test
