// SPDX-License-Identifier: MIT
// Types in capitals, mirrors and glass by the names of other formats: as Mitsuba's plugins, without a warning. Numbers
// with an f behind them, with one.
#include <catch2/catch.hpp>

#include "scene/scene_text.h"

namespace strahl::test {
namespace {

Material material(const std::string& bsdf) {
  const LoadedScene loaded = load_body("<shape type=\"sphere\">" + bsdf + "</shape>");
  CHECK(shortened(loaded.warnings).empty());
  return loaded.scene.materials.at(static_cast<std::size_t>(loaded.scene.shapes.at(0).material));
}

}  // namespace

TEST_CASE("types in capitals are those of file systems that ignore case") {
  const LoadedScene loaded = load_body(
      "<shape type=\"Sphere\"><bsdf type=\"TwoSided\"><bsdf type=\"Diffuse\"/></bsdf></shape>"
      "<shape type=\"Rectangle\"><emitter type=\"AREA\"/></shape>");
  CHECK(shortened(loaded.warnings).empty());
  REQUIRE(loaded.scene.shapes.size() == 2);
  CHECK(std::holds_alternative<Sphere>(loaded.scene.shapes[0].geometry));
  CHECK(std::holds_alternative<Rectangle>(loaded.scene.shapes[1].geometry));
  CHECK(loaded.scene.shapes[1].radiance.has_value());
}

TEST_CASE("a mirror is an ideal conductor") {
  const std::string reflectance = "<rgb name=\"reflectance\" value=\"0.9, 0.8, 0.7\"/>";
  const Material plain = material("<bsdf type=\"mirror\"/>"),
                 tinted = material("<bsdf type=\"mirror\">" + reflectance + "</bsdf>"),
                 same = material(
                     "<bsdf type=\"conductor\"><rgb name=\"specular_reflectance\" value=\"0.9, 0.8, 0.7\"/>"
                     "</bsdf>");
  CHECK(std::get<Conductor>(plain.bsdf).reflectance.color == Rgb{1, 1, 1});
  CHECK(std::get<Conductor>(tinted.bsdf).reflectance.color == std::get<Conductor>(same.bsdf).reflectance.color);
  CHECK(std::get<Conductor>(tinted.bsdf).index.eta.color == Rgb{0, 0, 0});
  CHECK(std::holds_alternative<Conductor>(material("<bsdf type=\"Mirror\"/>").bsdf));
  const std::string text =
      "<scene version=\"0.6.0\"><shape type=\"sphere\"><bsdf type=\"mirror\"/></shape>"
      "<sensor type=\"perspective\"/></scene>";
  const Scene old = load_text(text).scene;
  INFO("in 0.x as well, where conductors without a name are copper");
  CHECK(
      std::get<Conductor>(old.materials.at(static_cast<std::size_t>(old.shapes.at(0).material)).bsdf).index.eta.color ==
      Rgb{0, 0, 0});
}

TEST_CASE("glass is smooth, or rough where it has an alpha") {
  const std::string index = "<float name=\"int_ior\" value=\"1.7\"/>";
  CHECK(std::get<Dielectric>(material("<bsdf type=\"glass\">" + index + "</bsdf>").bsdf).int_ior == 1.7);
  const Material rough = material("<bsdf type=\"glass\">" + index + "<float name=\"alpha\" value=\"0.3\"/></bsdf>");
  const auto& glass = std::get<RoughDielectric>(rough.bsdf);
  CHECK(glass.microfacets.alpha_u.color.r == 0.3);
}

TEST_CASE("names that no format has stay unknown, as they were written") {
  const std::vector<std::string> found = shortened(load_body("<shape type=\"Torus\"/>").warnings);
  REQUIRE(found.size() == 1);
  CHECK(found[0].find("unknown shape \"Torus\"") != std::string::npos);
}

TEST_CASE("an f behind a number is dropped with a warning; other texts are no numbers") {
  const LoadedScene loaded = load_body(
      "<shape type=\"sphere\"><float name=\"radius\" value=\"2.5f\"/><transform name=\"to_world\">"
      "<translate x=\"1F\" y=\"-2e1f\"/></transform>\n<bsdf type=\"diffuse\"><rgb name=\"reflectance\" "
      "value=\"0.25f, .5 1f\"/></bsdf></shape><shape type=\"sphere\"><bsdf type=\"diffuse\"><rgb name=\"reflectance\" "
      "value=\"#ffffff\"/></bsdf></shape>");
  CHECK(shortened(loaded.warnings) ==
        std::vector<std::string>{"2:22: note: 2.5f in <float> is read without its f, which Mitsuba 3.9 refuses",
                                 "2:84: note: 1F in <translate> is read without its f, which Mitsuba 3.9 refuses",
                                 "2:84: note: -2e1f in <translate> is read without its f, which Mitsuba 3.9 refuses",
                                 "3:22: note: 0.25f, .5 1f in <rgb> is read without its f, which Mitsuba 3.9 refuses"});
  const auto sphere = std::get<Sphere>(loaded.scene.shapes.at(0).geometry);
  CHECK(sphere.radius == 2.5);
  CHECK(sphere.center == Vec3{1, -20, 0});
  CHECK(std::get<Diffuse>(loaded.scene.materials.at(1).bsdf).reflectance.color == Rgb{.25, .5, 1});
  std::string many;
  for (int i = 1; i < 9; ++i)
    many += "<shape type=\"sphere\"><float name=\"radius\" value=\"" + std::to_string(i) + ".5f\"/></shape>\n";
  CHECK(shortened(load_body(many).warnings).size() == 1);
  for (const char* text : {"f", "1ff", "0x1f", "1 f", "2f3"}) {
    INFO(text);
    CHECK_THROWS(
        load_body("<shape type=\"sphere\"><float name=\"radius\" value=\"" + std::string(text) + "\"/></shape>"));
  }
}

}  // namespace strahl::test
