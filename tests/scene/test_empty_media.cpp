// SPDX-License-Identifier: MIT
// Media of nothing are left out, and so is what they fill; what can be noticed stays.
#include <catch2/catch.hpp>

#include "scene/empty_media.h"
#include "scene/scene_text.h"

using namespace strahl;
using namespace strahl::test;

namespace {

const std::string ball = "<shape type=\"sphere\"><bsdf type=\"diffuse\"/></shape>";

std::string filled_cube(const std::string& sigma_t, const std::string& bsdf = "<bsdf type=\"null\"/>") {
  return "<shape type=\"cube\">" + bsdf +
         "<medium type=\"homogeneous\" name=\"interior\"><rgb name=\"sigma_t\" value=\"" + sigma_t +
         "\"/></medium></shape>";
}

Scene left_of(const std::string& body, const std::string& integrator = "volpath") {
  Scene scene = load_body("<integrator type=\"" + integrator + "\"/>" + body).scene;
  leave_out_empty_media(scene);
  return scene;
}

}  // namespace

TEST_CASE("a scene whose media are empty is one without them") {
  const Scene scene = left_of(filled_cube("0 0 0") + ball + filled_cube("0 0 0"));
  CHECK(scene.integrator.name == "path");
  CHECK(scene.media.empty());
  REQUIRE(scene.shapes.size() == 1);
  CHECK(std::holds_alternative<Sphere>(scene.shapes.front().geometry));
}

TEST_CASE("a medium says whether lights are drawn in it") {
  const auto draws_lights = [](const std::string& said) {
    const std::string medium = "<medium type=\"homogeneous\" name=\"interior\">" + said + "</medium>";
    return load_body("<shape type=\"cube\"><bsdf type=\"null\"/>" + medium + "</shape>")
        .scene.media.at(0)
        .samples_emitters;
  };
  CHECK(draws_lights(""));
  CHECK(draws_lights("<boolean name=\"sample_emitters\" value=\"true\"/>"));
  CHECK_FALSE(draws_lights("<boolean name=\"sample_emitters\" value=\"false\"/>"));
}

TEST_CASE("what can be noticed stays") {
  const Scene one = left_of(filled_cube("0 0 0") + ball + filled_cube("0 1e-9 0"));
  CHECK(one.integrator.name == "volpath");
  CHECK(one.shapes.size() == 3);
  CHECK(one.media.size() == 2);
  CHECK(one.shapes.front().media);
  const Scene glass = left_of(filled_cube("0 0 0", "<bsdf type=\"dielectric\"/>") + ball);
  CHECK(glass.integrator.name == "path");
  CHECK(glass.shapes.size() == 2);
  const Scene veiled = left_of(filled_cube("0 0 0") + "<shape type=\"sphere\"><bsdf type=\"mask\"><float " +
                               "name=\"opacity\" value=\"0.5\"/><bsdf type=\"diffuse\"/></bsdf></shape>");
  CHECK(veiled.integrator.name == "volpath");
  CHECK(veiled.shapes.size() == 1);
  // To path what lets light pass counts as depth.
  CHECK(left_of(filled_cube("0 0 0") + ball, "path").shapes.size() == 2);
}
