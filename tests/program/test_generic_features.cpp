// SPDX-License-Identifier: MIT
// What --generic puts into programs.
#include <catch2/catch.hpp>
#include <set>

#include "program/features.h"
#include "program/program_text.h"

using namespace strahl;

TEST_CASE("--generic has everything on but counters, watched loops, what changes the picture and other kernels") {
  Scene scene;
  scene.shapes.resize(1);
  scene.film.filter.kind = FilterKind::box;  // Others call for SHARED_SAMPLES.
  RenderSettings settings;
  settings.generic = true;
  const std::set<std::string> never = {"COUNT_RAYS", "LOOP_LIMIT", "TEXTURE_LOD", "MOMENT", "SHARED_SAMPLES"};
  for (const std::string integrator : {"direct", "ptracer", "bdpt"}) {
    scene.integrator.name = integrator;
    for (const FeatureReport& row : features_of(scene, settings).report) {
      INFO(integrator << ", " << row.name);
      const bool of_lights = row.name == "integrators/ptracer" || row.name == "integrators/bdpt";
      const bool is_other = of_lights && row.name != "integrators/" + integrator;
      const std::set<std::string> others = integrator == "direct"
                                               ? std::set<std::string>{"LIGHT_PATHS"}
                                               : std::set<std::string>{"MEDIA", "OPEN_MEDIA", "UNLIT_MEDIA", "PANE"};
      const bool is_elsewhere = is_other || others.contains(row.name);
      CHECK(row.on == (!never.contains(row.name) && !is_elsewhere));
    }
  }
}

TEST_CASE("a program with everything leaves to its compiler what it inlines, one of a scene's own does not") {
  Scene scene;
  scene.shapes.resize(1);
  for (const bool generic : {false, true}) {
    RenderSettings settings;
    settings.generic = generic;
    const std::string text =
        program_source("kernels/render.cl", features_of(scene, settings), Precision::robust, 16).text;
    CHECK((text.find("#define KEEPS_FUNCTIONS 1\n") != std::string::npos) == generic);
  }
}
