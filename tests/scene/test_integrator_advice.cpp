// SPDX-License-Identifier: MIT
// What an integrator misses, and which one finds it.
#include <catch2/catch.hpp>

#include "scene/integrator_advice.h"
#include "scene/scene_text.h"

using namespace strahl;
using namespace strahl::test;

namespace {

std::vector<Advice> advice(const std::string& integrator, const std::string& body) {
  return integrator_advice(load_body("<integrator type=\"" + integrator + "\"/>" + body).scene);
}

const std::string point_lamp = "<emitter type=\"point\"/>";
const std::string floor_shape = "<shape type=\"rectangle\"/>";
const std::string glass = "<shape type=\"sphere\"><bsdf type=\"dielectric\"/></shape>";

std::string ball_lamp(const std::string& radius) {
  return "<shape type=\"sphere\"><float name=\"radius\" value=\"" + radius + "\"/><emitter type=\"area\"/></shape>";
}

}  // namespace

TEST_CASE("a point over glass makes what paths from the camera miss") {
  const std::vector<Advice> found = advice("path", point_lamp + floor_shape + glass);
  REQUIRE(found.size() == 1);
  CHECK(found[0].integrator == "bdpt");
  CHECK(found[0].where.line == 2);
  CHECK(advice("ptracer", point_lamp + floor_shape + glass).empty());
  CHECK(advice("bdpt", point_lamp + floor_shape + glass).empty());
  CHECK(advice("path", point_lamp + floor_shape).empty());
  CHECK(advice("normals", point_lamp + floor_shape + glass).empty());
  CHECK(advice("path", "<emitter type=\"constant\"/>" + glass).empty());
}

TEST_CASE("beams ask for paths from lights, and where the camera looks at mirrors for both ends") {
  const std::string beam = "<emitter type=\"collimated\"/>";
  const std::string screen = "<shape type=\"disk\"><emitter type=\"directionalarea\"/></shape>";
  for (const std::string& lamp : {beam, screen}) {
    INFO(lamp);
    REQUIRE(advice("path", lamp + floor_shape).size() == 1);
    CHECK(advice("path", lamp + floor_shape)[0].integrator == "ptracer");
    CHECK(advice("path", lamp + floor_shape)[0].where.line == 2);
    for (const std::string& more : {glass, point_lamp}) {
      REQUIRE(advice("path", lamp + floor_shape + more).size() == 1);
      CHECK(advice("path", lamp + floor_shape + more)[0].integrator == "bdpt");
    }
    for (const char* finds : {"ptracer", "bdpt"}) CHECK(advice(finds, lamp + floor_shape + glass).empty());
  }
  const std::string dark = "<emitter type=\"collimated\"><rgb name=\"power\" value=\"0\"/></emitter>";
  CHECK(advice("path", dark + floor_shape).empty());
}

TEST_CASE("nothing that refuses the scene is advised") {
  const std::string ranked =
      "<shape type=\"sphere\"><bsdf type=\"dielectric\"/><integer name=\"priority\" value=\"1\"/></shape>";
  const std::string sun = "<emitter type=\"directional\"/>", ground = "<shape type=\"plane\"/>";
  CHECK(advice("path", point_lamp + floor_shape + ranked).empty());
  CHECK(advice("path", sun + ground + glass).empty());
  CHECK(advice("path", sun + floor_shape + glass).size() == 1);
  const std::string beam = "<emitter type=\"collimated\"/>";
  REQUIRE(advice("path", beam + floor_shape + ranked).size() == 1);
  CHECK(advice("path", beam + floor_shape + ranked)[0].integrator == "ptracer");
}

TEST_CASE("a lamp that is small beside the scene is found by chance alone") {
  CHECK(advice("path", ball_lamp("0.01") + glass).size() == 1);
  CHECK(advice("path", ball_lamp("0.5") + glass).empty());
}

TEST_CASE("what integrators leave out by what they are is missed, where there is any of it") {
  const auto misses = [](const std::string& integrator, const std::string& body) {
    return integrator_misses(load_body("<integrator type=\"" + integrator + "\"/>" + body).scene);
  };
  const std::string sky = "<emitter type=\"constant\"/>";
  for (const char* finds : {"path", "ptracer", "bdpt"}) CHECK(misses(finds, sky + floor_shape + floor_shape).empty());
  for (const char* once : {"direct", "whitted"}) {
    CHECK(misses(once, sky + floor_shape).empty());
    const std::string undrawn = "<emitter type=\"point\"><float name=\"sampling_weight\" value=\"0\"/></emitter>";
    CHECK(misses(once, undrawn + floor_shape).empty());
    REQUIRE(misses(once, sky + floor_shape + floor_shape).size() == 1);
    CHECK(misses(once, sky + floor_shape + floor_shape)[0].find("more than once") != std::string::npos);
  }
  REQUIRE(misses("ptracer", sky + floor_shape + glass).size() == 1);
  CHECK(misses("bdpt", sky + floor_shape + glass).empty());
  CHECK(misses("path", point_lamp + floor_shape + glass).size() == 1);
}

TEST_CASE("media and masks ask for volpath") {
  const std::string fog = "<shape type=\"cube\"><medium type=\"homogeneous\" name=\"interior\"/></shape>";
  REQUIRE(advice("path", fog + point_lamp).size() == 1);
  CHECK(advice("path", fog + point_lamp)[0].integrator == "volpath");
  CHECK(advice("volpath", fog + point_lamp + glass).empty());
  const std::string veil =
      "<shape type=\"rectangle\"><bsdf type=\"mask\"><float name=\"opacity\" value=\"0.5\"/>"
      "<bsdf type=\"diffuse\"/></bsdf></shape>";
  REQUIRE(advice("path", veil + point_lamp).size() == 1);
  CHECK(advice("path", veil + point_lamp)[0].integrator == "volpath");
  CHECK(advice("path", veil).empty());
}
