// SPDX-License-Identifier: MIT
// Integrator aov calls for effects where its values are asked for, and says so where they are not.
#include <algorithm>
#include <catch2/catch.hpp>

#include "program/features.h"

using namespace strahl;

TEST_CASE("AOVs that a scene names call for effects where they are written") {
  Scene scene;
  scene.shapes.emplace_back().geometry = Sphere{};
  scene.integrator.aovs = {{"colour", Aov::albedo}, {"way", Aov::depth}};
  scene.integrator.aovs_where = {"scene.xml", 3, 1};
  const auto row = [&](const RenderSettings& settings, const std::string& name) {
    const Features features = features_of(scene, settings);
    const auto found = std::find_if(features.report.begin(), features.report.end(),
                                    [&](const FeatureReport& one) { return one.name == name; });
    REQUIRE(found != features.report.end());
    return *found;
  };
  const FeatureReport off = row({}, "AOV");
  CHECK_FALSE(off.on);
  CHECK(off.why == "integrator aov calls for it where an .exr is written");
  CHECK(off.where.line == 3);
  CHECK_FALSE(row({}, "ALBEDO").on);

  RenderSettings settings;
  for (const NamedAov& named : scene.integrator.aovs) settings.aovs.add(named);
  for (const char* name : {"AOV", "ALBEDO"}) {
    INFO(name);
    CHECK(row(settings, name).on);
    CHECK(row(settings, name).where.line == 3);
  }
  CHECK(row(settings, "AOV").why == "integrator aov");
  settings.aovs.add(Aov::albedo);
  CHECK(row(settings, "ALBEDO").why == "--aov albedo");
  CHECK(row(settings, "ALBEDO").where.line == 0);
}

TEST_CASE("second moments call for an effect of their own, and for no first samples") {
  Scene scene;
  scene.shapes.emplace_back().geometry = Sphere{};
  scene.integrator.aovs = {{"p", Aov::xyz}, {"m2_p", Aov::xyz_squared}};
  RenderSettings settings;
  CHECK_FALSE(features_of(scene, settings).flag("MOMENT"));
  settings.generic = true;
  CHECK_FALSE(features_of(scene, settings).flag("MOMENT"));
  settings.generic = false;
  for (const NamedAov& named : scene.integrator.aovs) settings.aovs.add(named);
  CHECK(features_of(scene, settings).flag("MOMENT"));
  CHECK_FALSE(features_of(scene, settings).flag("AOV"));
}
