// SPDX-License-Identifier: MIT
// What stands for the plugins that strahl does not have.
#include <catch2/catch.hpp>

#include "scene/scene_text.h"

using namespace strahl;
using namespace strahl::test;

TEST_CASE("substitutes keep what they can") {
  const Scene scene =
      load_body(
          "<bsdf type=\"hk\"><rgb name=\"diffuse_reflectance\" value=\".1 .2 .3\"/></bsdf>"
          "<bsdf type=\"roughcoating\"><bsdf type=\"diffuse\"><rgb name=\"reflectance\" value=\".4\"/></bsdf>"
          "</bsdf><bsdf type=\"hair\"/>")
          .scene;
  REQUIRE(scene.materials.size() == 4);
  CHECK(std::get<Diffuse>(scene.materials[1].bsdf).reflectance.color == Rgb{.1, .2, .3});
  CHECK(std::get<Diffuse>(scene.materials[2].bsdf).reflectance.color == Rgb{.4, .4, .4});
  CHECK(std::get<Diffuse>(scene.materials[3].bsdf).reflectance.color == Rgb{.5, .5, .5});
}

TEST_CASE("what stands for an unknown bsdf keeps its texture, and no parameter that is no colour") {
  const Scene scene = load_body(
                          "<bsdf type=\"cloth\"><texture type=\"checkerboard\" name=\"base_color\"/></bsdf>"
                          "<bsdf type=\"cloth\"><vector name=\"base_color\" value=\"0, 1, 0\"/></bsdf>"
                          "<bsdf type=\"cloth\"><string name=\"reflectance\" value=\"green\"/>"
                          "<rgb name=\"base_color\" value=\".1 .2 .3\"/></bsdf>")
                          .scene;
  REQUIRE(scene.materials.size() == 4);
  CHECK(std::get<Diffuse>(scene.materials[1].bsdf).reflectance.texture == 0);
  CHECK(std::holds_alternative<Checkerboard>(scene.textures.at(0).pattern));
  CHECK(std::get<Diffuse>(scene.materials[2].bsdf).reflectance.color == Rgb{.5, .5, .5});
  CHECK(std::get<Diffuse>(scene.materials[3].bsdf).reflectance.color == Rgb{.1, .2, .3});
}

TEST_CASE("a polarizing plastic becomes a rough one with its parameters") {
  const LoadedScene loaded = load_body(
      "<bsdf type=\"pplastic\"><rgb name=\"diffuse_reflectance\" value=\".1 .2 .3\"/><float name=\"alpha\" "
      "value=\"0.2\"/><string name=\"distribution\" value=\"ggx\"/></bsdf>");
  REQUIRE(loaded.warnings.size() == 1);
  CHECK(loaded.warnings[0].message == "bsdf \"pplastic\" is not supported yet; \"roughplastic\" takes its place");
  const auto plastic = std::get<RoughPlastic>(loaded.scene.materials.at(1).bsdf);
  CHECK(plastic.plastic.diffuse_reflectance.color == Rgb{.1, .2, .3});
  CHECK(plastic.microfacets.alpha_u.color == Rgb{.2, .2, .2});
}

TEST_CASE("filters of polarization pass what they pass of unpolarized light") {
  const LoadedScene loaded = load_body(
      "<bsdf type=\"polarizer\"><spectrum name=\"theta\" value=\"30\"/></bsdf><bsdf type=\"circular\">"
      "<boolean name=\"left_handed\" value=\"true\"/><rgb name=\"transmittance\" value=\".2 .4 .6\"/></bsdf>"
      "<bsdf type=\"retarder\"><spectrum name=\"delta\" value=\"90\"/>"
      "<rgb name=\"transmittance\" value=\".2 .4 .6\"/></bsdf>");
  CHECK(loaded.warnings.empty());
  const Rgb passed[] = {{.5, .5, .5}, {.1, .2, .3}, {.2, .4, .6}};
  REQUIRE(loaded.scene.materials.size() == 4);
  for (std::size_t i = 0; i < 3; ++i) {
    const Dielectric& pane = std::get<ThinDielectric>(loaded.scene.materials[i + 1].bsdf).glass;
    CHECK(pane.int_ior == pane.ext_ior);
    CHECK(pane.transmittance.color == passed[i]);
  }
}

TEST_CASE("a polarizer with a textured transmittance passes half of it") {
  const Scene scene = load_body(
                          "<bsdf type=\"polarizer\"><texture type=\"checkerboard\" name=\"transmittance\"/>"
                          "</bsdf><bsdf type=\"retarder\"><texture type=\"checkerboard\" "
                          "name=\"transmittance\"/></bsdf>")
                          .scene;
  REQUIRE(scene.materials.size() == 5);
  const Blend& blend = std::get<Blend>(scene.materials[3].bsdf);
  const auto row = [&](int index) { return scene.materials.at(static_cast<std::size_t>(index)).bsdf; };
  CHECK(blend.weight.color == Rgb{.5, .5, .5});
  CHECK(std::get<Diffuse>(row(blend.first)).reflectance.color == Rgb{});
  CHECK(std::get<ThinDielectric>(row(blend.second)).glass.transmittance.texture == 0);
  CHECK(std::get<ThinDielectric>(row(4)).glass.transmittance.texture == 1);
}

TEST_CASE("an unknown integrator becomes volpath where there are media, around the camera too, else path") {
  const std::string unknown = "<integrator type=\"volsample\"/>", fog = "<medium type=\"homogeneous\" name=";
  const auto named = [](const std::string& text) {
    const LoadedScene loaded = load_text("<scene version=\"3.0.0\">" + text + "</scene>");
    REQUIRE(loaded.warnings.size() == 1);
    CHECK(loaded.warnings[0].message ==
          "unknown integrator \"volsample\"; \"" + loaded.scene.integrator.name + "\" takes its place");
    return loaded.scene.integrator.name;
  };
  const std::string sensor = "<sensor type=\"perspective\"/>", ball = "<shape type=\"sphere\">";
  CHECK(named(unknown + ball + "</shape>" + sensor) == "path");
  CHECK(named(unknown + ball + "<bsdf type=\"null\"/>" + fog + "\"interior\"/></shape>" + sensor) == "volpath");
  CHECK(named(unknown + ball + "</shape><sensor type=\"perspective\">" + fog + "\"medium\"/></sensor>") == "volpath");
}
