// SPDX-License-Identifier: MIT
// The generic program, which holds every effect, gives every scene of the project bit for bit the picture and the AOVs
// of the program made for it: in the robust tier the scenes that call for an effect that none of more effects has
// called for; with STRAHL_ALL_TIERS all of them, in stable and double too, each with AOVs and without.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>
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
  // Where one scene shows many effects, few scenes show all.
  std::stable_sort(scenes.begin(), scenes.end(),
                   [](const auto& a, const auto& b) { return effects(a).size() > effects(b).size(); });
  return scenes;
}

/// Whether the scene calls for what is not among `seen`, which it is added to.
bool is_new(const std::filesystem::path& path, std::set<std::string>& seen) {
  const std::size_t before = seen.size();
  seen.merge(effects(path));
  return seen.size() > before;
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
  std::set<std::string> seen;
  for (const std::filesystem::path& scene : scenes) {
    if (!all) {
      if (is_new(scene, seen)) hold(scene, Precision::robust, false);
      continue;
    }
    hold(scene, Precision::robust, true);
    hold(scene, Precision::stable, true);
    hold(scene, Precision::fp64, true);
  }
  CHECK(seen.size() >= (all ? 0 : 28));
}

TEST_CASE("values beside the picture") {
  require_pocl_and_rusticl();
  hold(scene_folder / "lecture/lit.xml", all_aovs());
}

}  // namespace
}  // namespace strahl::test
