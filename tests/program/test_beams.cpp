// SPDX-License-Identifier: MIT
// Beams are in the programs of integrators whose paths begin on lights, and in no others.
#include <catch2/catch.hpp>

#include "kinds/integrators.h"
#include "program/program_text.h"

using namespace strahl;

namespace {

Scene beam_ball(const std::string& integrator) {
  Scene scene;
  scene.integrator.name = integrator;
  scene.shapes.resize(1);
  return scene;
}

std::string beam_text_of(const Scene& scene) {
  return program_source(kinds::integrator(scene.integrator.name).kernel(), features_of(scene, {}), Precision::robust, 8)
      .text;
}

}  // namespace

TEST_CASE("Beams count where paths begin on lights") {
  for (const std::string kind : {"collimated", "directionalarea"})
    for (const std::string& integrator : kinds::integrator_names()) {
      INFO(kind << ", " << integrator);
      const Scene without = beam_ball(integrator);
      Scene scene = without;
      if (kind == "collimated")
        scene.lights.push_back({"", CollimatedLight{}, {}});
      else
        scene.shapes.front().exitance = Rgb{1, 1, 1};
      const bool is_there = kinds::integrator(integrator).from_lights;
      const Features features = features_of(scene, {});
      CHECK(features.has("lights", kind) == is_there);
      CHECK(features.has("areas", "sphere") == (is_there && kind == "directionalarea"));
      CHECK_FALSE(features.flag("EMISSION"));
      CHECK((beam_text_of(scene) == beam_text_of(without)) == !is_there);  // too long to be printed
    }
}

TEST_CASE("hide_emitters hides a surface that shines in a beam, as one that emits") {
  for (const std::string& integrator : kinds::integrator_names()) {
    INFO(integrator);
    Scene scene = beam_ball(integrator);
    scene.shapes.front().exitance = Rgb{1, 1, 1};
    scene.integrator.hide_emitters = true;
    const bool is_hidden = kinds::integrator(integrator).shows_emission;
    CHECK(features_of(scene, {}).flag("EMISSION") == is_hidden);
    CHECK(features_of(scene, {}).flag("HIDE_EMITTERS") == is_hidden);
  }
}
