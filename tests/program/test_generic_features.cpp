// SPDX-License-Identifier: MIT
// What --generic puts into programs.
#include <catch2/catch.hpp>
#include <set>

#include "program/features.h"

using namespace strahl;

TEST_CASE("--generic has everything on but counters, watched loops, what changes the picture and other kernels") {
  Scene scene;
  scene.shapes.resize(1);
  RenderSettings settings;
  settings.generic = true;
  const std::set<std::string> never = {"COUNT_RAYS", "LOOP_LIMIT", "TEXTURE_LOD"};
  for (const std::string integrator : {"direct", "ptracer"}) {
    scene.integrator.name = integrator;
    for (const FeatureReport& row : features_of(scene, settings).report) {
      INFO(integrator << ", " << row.name);
      const bool of_light_paths = row.name == "integrators/ptracer" || row.name == "LIGHT_PATHS";
      const bool is_elsewhere = integrator == "ptracer" ? row.name == "MEDIA" : of_light_paths;
      CHECK(row.on == (!never.contains(row.name) && !is_elsewhere));
    }
  }
}
