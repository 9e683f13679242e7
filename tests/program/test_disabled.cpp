// SPDX-License-Identifier: MIT
// What --disable takes out of a program, what it takes with it, and what it refuses.
#include <algorithm>
#include <catch2/catch.hpp>
#include <set>

#include "program/features.h"

using namespace strahl;

namespace {

Scene glowing_sphere() {
  Scene scene;
  scene.integrator.name = "path";
  scene.shapes.resize(1);
  scene.shapes[0].radiance = Rgb{1, 1, 1};
  scene.materials[0].twosided = true;
  return scene;
}

FeatureReport report(const RenderSettings& settings, const std::string& name) {
  const Features features = features_of(glowing_sphere(), settings);
  const auto found = std::find_if(features.report.begin(), features.report.end(),
                                  [&](const FeatureReport& row) { return row.name == name; });
  REQUIRE(found != features.report.end());
  return *found;
}

}  // namespace

TEST_CASE("What is disabled is off, whatever calls for it, and so is what means nothing without it") {
  for (const bool generic : {false, true}) {
    RenderSettings settings;
    settings.generic = generic;
    const auto check_off = [&](const std::string& name) {
      INFO(name);
      CHECK_FALSE(report(settings, name).on);
      CHECK(report(settings, name).why == "--disable");
    };
    settings.disabled = {"TWOSIDED"};
    check_off("TWOSIDED");
    CHECK(report(settings, "areas/sphere").on);
    settings.disabled = {"EMISSION"};
    for (const char* name : {"EMISSION", "lights/area", "areas/sphere", "areas/disk"}) check_off(name);
    settings.disabled = {"lights/area"};
    CHECK(report(settings, "areas/sphere").on == generic);  // Of directionalarea.
    settings.disabled = {"lights/area", "lights/directionalarea"};
    check_off("areas/sphere");
    settings.disabled = {"areas/sphere"};
    check_off("areas/sphere");
    CHECK(report(settings, "lights/area").on == generic);
    settings.disabled = {"shapes/sphere"};
    check_off("shapes/sphere");
    CHECK(report(settings, "materials/diffuse").on == generic);
  }
}

TEST_CASE("Effects that are unknown or needed cannot be disabled, and the message says what can") {
  const auto message = [](const std::string& name) {
    RenderSettings settings;
    settings.disabled = {name};
    try {
      static_cast<void>(features_of(glowing_sphere(), settings));
    } catch (const UsageError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  CHECK_THAT(message("shapes/sphre"), Catch::Contains("did you mean \"shapes/sphere\"") &&
                                          Catch::Contains("SMOOTH_NORMALS") && Catch::Contains("lights/point") &&
                                          !Catch::Contains("integrators/"));
  CHECK_THAT(message("integrators/path"), Catch::Contains("--integrator"));
  CHECK_THAT(message("samplers/sobol"), Catch::Contains("--sampler"));
  CHECK_THAT(message("AOV"), Catch::Contains("--aov"));
  const std::set<std::string> needed{"integrators", "samplers", "choosers", "media", "phases"};
  for (const std::string& list : list_folders())
    for (const std::string& entry : list_entries(list))
      CHECK((message(list + "/" + entry).empty()) == (!needed.contains(list)));
}
