// SPDX-License-Identifier: MIT
// Which integrator "auto" takes: the cheapest that shows what path shows.
#include <catch2/catch.hpp>

#include "scene/scene_text.h"
#include "settings/sampling.h"

using namespace strahl;
using namespace strahl::test;

namespace {

const std::string lamp = "<emitter type=\"point\"/><shape type=\"sphere\"><emitter type=\"area\"/></shape>";

IntegratorSettings chosen(const std::string& body) { return load_body(body + lamp).scene.integrator; }

std::string shape_of(const std::string& type, const std::string& inside = "") {
  return "<shape type=\"" + type + "\">" + inside + "</shape>";
}

}  // namespace

TEST_CASE("without a surface that reflects it is emission") {
  CHECK(chosen("").name == "emission");
  CHECK(chosen("").why == "no surface reflects light");
  const std::string black = "<bsdf type=\"diffuse\"><rgb name=\"reflectance\" value=\"0\"/></bsdf>";
  CHECK(chosen(shape_of("cube", black)).name == "emission");
  const std::string board =
      "<bsdf type=\"diffuse\"><texture type=\"checkerboard\" name=\"reflectance\"><rgb name=\"color0\" value=\"0\"/>"
      "<rgb name=\"color1\" value=\"0\"/></texture></bsdf>";
  CHECK(chosen(shape_of("rectangle", board)).name == "direct");
}

TEST_CASE("emission that auto takes has the edges of path, one that is named a ray a pixel") {
  const auto sampling = [](const std::string& body) { return resolve_sampling(load_body(body + lamp).scene); };
  const ResolvedSampling chosen_one = sampling(""), named = sampling("<integrator type=\"emission\"/>");
  CHECK(chosen_one.kind == SamplerKind::sobol);
  CHECK(chosen_one.spp == sampling("<integrator type=\"path\"/>").spp);
  CHECK(named.kind == SamplerKind::centre);
  CHECK(named.spp == 1);
}

TEST_CASE("with one convex surface that reflects it is direct") {
  for (const char* type : {"plane", "rectangle", "disk", "sphere", "cube"}) {
    INFO(type);
    CHECK(chosen(shape_of(type)).name == "direct");
  }
  const std::string twosided = "<bsdf type=\"twosided\"><bsdf type=\"diffuse\"/></bsdf>";
  CHECK(chosen(shape_of("rectangle", twosided)).name == "direct");
  CHECK(chosen(shape_of("sphere", twosided)).name == "path");
  CHECK(chosen(shape_of("sphere", "<boolean name=\"flip_normals\" value=\"true\"/>")).name == "path");
  CHECK(chosen(shape_of("cylinder")).name == "path");
  CHECK(chosen(shape_of("rectangle", "<bsdf type=\"conductor\"/>")).name == "path");
  CHECK(chosen(shape_of("sphere", "<bsdf type=\"dielectric\"/>")).name == "path");
  CHECK(chosen(shape_of("sphere") + shape_of("plane")).name == "path");
}

TEST_CASE("where all light is in beams it is ptracer, but for media") {
  const auto lit_by = [](const std::string& body) { return load_body(body).scene.integrator.name; };
  const std::string beam = "<emitter type=\"collimated\"/>", cylinder = shape_of("cylinder");
  const std::string screen = shape_of("disk", "<emitter type=\"directionalarea\"/>");
  CHECK(lit_by(beam + shape_of("rectangle")) == "ptracer");
  CHECK(lit_by(screen + cylinder) == "ptracer");
  CHECK(lit_by(beam + "<emitter type=\"point\"/>" + cylinder) == "path");
  CHECK(lit_by(screen + shape_of("sphere", "<emitter type=\"area\"/>") + cylinder) == "path");
  CHECK(lit_by(screen) == "emission");
  CHECK(lit_by(beam + shape_of("cube", "<medium type=\"homogeneous\" name=\"interior\"/>")) == "volpath");
}

TEST_CASE("a lamp that is never drawn has no light by path, so it is not direct, which takes all") {
  const auto lit_by = [](const std::string& weight, const std::string& depth) {
    return load_body("<integrator type=\"auto\"><integer name=\"max_depth\" value=\"" + depth +
                     "\"/></integrator><emitter type=\"point\"><float name=\"sampling_weight\" value=\"" + weight +
                     "\"/></emitter>" + lamp + shape_of("rectangle"))
        .scene.integrator.name;
  };
  for (const char* depth : {"-1", "2"}) {
    CHECK(lit_by("0", depth) == "path");
    CHECK(lit_by("0.5", depth) == "direct");
  }
  const std::string unseen = "<float name=\"sampling_weight\" value=\"0\"/>";
  CHECK(
      load_body("<emitter type=\"constant\">" + unseen + "</emitter>" + shape_of("rectangle")).scene.integrator.name ==
      "direct");
}

TEST_CASE("max_depth counts, and a name is obeyed") {
  const auto with_depth = [](const std::string& depth) {
    return chosen("<integrator type=\"auto\"><integer name=\"max_depth\" value=\"" + depth + "\"/></integrator>" +
                  shape_of("cylinder"));
  };
  CHECK(with_depth("0").name == "direct");  // Emission would show lights.
  CHECK(with_depth("1").name == "emission");
  CHECK(with_depth("2").name == "direct");
  CHECK(with_depth("3").name == "path");
  CHECK_FALSE(with_depth("3").why.empty());
  CHECK(chosen("<integrator type=\"direct\"/>" + shape_of("cylinder")).name == "direct");
  CHECK(chosen("<integrator type=\"direct\"/>" + shape_of("cylinder")).why.empty());
}

TEST_CASE("light goes on through masks, and a back may reflect where the front is black") {
  const std::string null = shape_of("cube", "<bsdf type=\"null\"/>");
  CHECK(chosen(shape_of("rectangle") + null).name == "path");
  CHECK(chosen(null).name == "path");
  CHECK(chosen("<integrator type=\"auto\"><integer name=\"max_depth\" value=\"2\"/></integrator>" + null).name ==
        "direct");
  const std::string mask = "<bsdf type=\"mask\"><float name=\"opacity\" value=\"0.5\"/><bsdf type=\"diffuse\"/></bsdf>";
  CHECK(chosen(shape_of("sphere", mask)).name == "path");
  const std::string sides =
      "<bsdf type=\"twosided\"><bsdf type=\"diffuse\"><rgb name=\"reflectance\" value=\"0\"/></bsdf>"
      "<bsdf type=\"diffuse\"/></bsdf>";
  CHECK(chosen(shape_of("rectangle", sides)).name == "direct");
  CHECK(chosen(shape_of("rectangle", sides) + shape_of("rectangle")).name == "path");
  // A body whose inside reflects, within a blend.
  const std::string side = "<bsdf type=\"twosided\"><bsdf type=\"diffuse\"/></bsdf>";
  CHECK(chosen(shape_of("cube", "<bsdf type=\"blendbsdf\">" + side + side + "</bsdf>")).name == "path");
}
