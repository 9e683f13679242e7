// SPDX-License-Identifier: MIT
// Nothing is ignored silently: unknown plugins and parameters warn, with --strict they are errors.
#include <catch2/catch.hpp>

#include "did_you_mean.h"
#include "scene/scene_text.h"

using namespace strahl;
using namespace strahl::test;

namespace {

struct Unknown {
  const char* body;
  const char* place;
  const char* words;
};

const Unknown unknowns[] = {
    {"<shape type=\"torus\"/>", "2:1", "unknown shape \"torus\"; it is left out"},
    {"<shape type=\"sphere\"><floot name=\"radius\" value=\"1\"/></shape>", "2:22",
     "<floot> (did you mean \"float\"?)"},
    {"<shape type=\"sphere\"><float name=\"Radius\" value=\"1\"/></shape>", "2:22", "did you mean \"radius\"?"},
    {"<shape type=\"sphere\" nmae=\"x\"/>", "2:1", "unknown attribute \"nmae\" of <shape> (did you mean \"name\"?)"},
    {"<shape type=\"sphere\">text</shape>", "2:1", "text inside <shape> is ignored"},
    {"<shape type=\"sphere\"><float name=\"radius\" value=\"1\"><float name=\"a\" value=\"1\"/></float></shape>",
     "2:53", "cannot contain"},
    {"<shape type=\"sphere\"><shape type=\"disk\"/></shape>", "2:22", "has no use for a <shape>"},
    {"<shape type=\"sphere\"><medium type=\"hetero\" name=\"interior\"/></shape>", "2:22", "unknown medium \"hetero\""},
    {"<shape type=\"sphere\"><bsdf type=\"hair\"><float name=\"roughness\" value=\"1\"/></bsdf></shape>", "2:22",
     "bsdf \"hair\" is not supported yet; a two-sided diffuse one of reflectance 0.5 takes its place"},
    {"<shape type=\"sphere\"><bsdf type=\"difuse\"/></shape>", "2:22", "did you mean \"diffuse\"?"},
    {"<shape type=\"sphere\"><emitter type=\"spot\"/></shape><emitter type=\"point\"/>", "2:22",
     "cannot be part of a shape"},
    {"<emitter type=\"area\"/>", "2:1", "belongs inside a <shape>"},
    {"<emitter type=\"directionalarea\"/>", "2:1", "belongs inside a <shape>"},
    {"<shape type=\"sphere\"><emitter type=\"collimated\"/></shape><emitter type=\"point\"/>", "2:22",
     "cannot be part of a shape"},
    {"<integrator type=\"pth\"/>", "2:1", "unknown integrator \"pth\" (did you mean \"path\"?); \"path\" takes"},
    {"<integrator type=\"path\"><integrator type=\"direct\"/></integrator>", "2:25", "has no use for a <integrator>"},
    {"<integrator type=\"path\"><float name=\"max_distance\" value=\"3\"/></integrator>", "2:25",
     "\"max_distance\" has no effect on integrator \"path\""},
    {"<integrator type=\"auto\"><float name=\"max_distance\" value=\"3\"/></integrator>", "2:25",
     "\"max_distance\" has no effect on integrator \"auto\""},
    {"<integrator type=\"depth\"><integer name=\"max_depth\" value=\"5\"/></integrator>", "2:26",
     "\"max_depth\" has no effect on integrator \"depth\""},
    {"<integrator type=\"ao\"><integer name=\"max_depth\" value=\"0\"/></integrator>", "2:23",
     "\"max_depth\" has no effect on integrator \"ao\""},
    {"<integrator type=\"ao\"><boolean name=\"hide_emitters\" value=\"true\"/></integrator>", "2:23",
     "\"hide_emitters\" has no effect on integrator \"ao\""},
    {"<integrator type=\"normals\"><boolean name=\"hide_emitters\" value=\"true\"/></integrator>", "2:28",
     "\"hide_emitters\" has no effect on integrator \"normals\""},
    {"<integrator type=\"direct\"><integer name=\"rr_depth\" value=\"5\"/></integrator>", "2:27",
     "\"rr_depth\" has no effect on integrator \"direct\""},
    {"<integrator type=\"direct\"><integer name=\"max_depth\" value=\"3\"/></integrator>", "2:27",
     "\"max_depth\" has no effect on integrator \"direct\", whose light goes no deeper than 2"},
    {"<integrator type=\"direct\"><integer name=\"max_depth\" value=\"-1\"/></integrator>", "2:27", "no deeper than 2"},
    {"<integrator type=\"emission\"><integer name=\"max_depth\" value=\"2\"/></integrator>", "2:29",
     "no deeper than 1"},
    {"<texture type=\"bitmap\"/>", "2:1", "without an id"},
    {"<bsdf type=\"diffuse\"><texture type=\"volume\" name=\"reflectance\"/></bsdf>", "2:22",
     "the constant 0.5 takes its place"},
    {"<bsdf type=\"diffuse\"><texture type=\"chekerboard\" name=\"reflectance\"/></bsdf>", "2:22",
     "unknown texture \"chekerboard\" (did you mean \"checkerboard\"?); the constant 0.5 takes its place"},
    {"<bsdf type=\"diffuse\"><spectrum type=\"blackbdoy\" name=\"reflectance\"/></bsdf>", "2:22",
     "unknown spectrum \"blackbdoy\" (did you mean \"blackbody\"?); the constant 0.5 takes its place"},
    {"<bsdf type=\"diffuse\"><texture type=\"wireframe\" name=\"reflectance\"/></bsdf>", "2:22",
     "texture \"wireframe\" is not supported yet; the constant 0.5 takes its place"},
    {"<medium type=\"homogeneous\" id=\"m\"><texture type=\"bitmap\" name=\"albedo\"/></medium><shape "
     "type=\"sphere\"><ref "
     "id=\"m\" name=\"interior\"/></shape>",
     "2:35", "texture \"bitmap\" is not supported yet here"},
    {"<bsdf type=\"diffuse\"><spectrum type=\"uniform\" name=\"reflectance\" value=\"0.3\"/></bsdf>", "2:22",
     "unknown attribute \"value\" of <spectrum type=\"uniform\">, whose parameters are elements inside it; it is "
     "ignored"},
    {"<bsdf type=\"diffuse\"><spectrum type=\"d65\" name=\"reflectance\" filename=\"a.spd\"/></bsdf>", "2:22",
     "unknown attribute \"filename\" of <spectrum type=\"d65\">"},
    {"<bsdf type=\"diffuse\"><spectrum name=\"reflectance\" value=\"0.3\"><float name=\"value\" "
     "value=\"1\"/></spectrum></bsdf>",
     "2:63", "a <spectrum> without a type cannot contain other elements"},
    {"<bsdf type=\"diffuse\"><spectrum type=\"d65\" name=\"reflectance\"><float name=\"scale\" value=\"3\"/><texture "
     "type=\"checkerboard\"/></spectrum></bsdf>",
     "2:62", "unknown parameter \"scale\" of <spectrum type=\"d65\">"},
    {"<bsdf type=\"roughconductor\"><string name=\"distribution\" value=\"phong\"/></bsdf>", "2:29",
     "the distribution \"phong\" is not supported; beckmann takes its place"},
    {"<shape type=\"sphere\"><integer name=\"priority\" value=\"1\"/></shape>", "2:22",
     "ranks shapes of bsdf dielectric and roughdielectric"},
    {"<shape type=\"sphere\"><integer name=\"priority\" value=\"1\"/><medium type=\"homogeneous\" "
     "name=\"interior\"/></shape>",
     "2:22", "and boundaries of media of bsdf null, mask and thindielectric"},
    {"<shape type=\"sphere\"><integer name=\"priority\" value=\"1\"/><medium type=\"homogeneous\" name=\"interior\"/>"
     "<bsdf type=\"blendbsdf\"><bsdf type=\"diffuse\"/><bsdf type=\"dielectric\"/></bsdf></shape>",
     "2:22", "\"priority\" has no effect here"},
    {"<bsdf type=\"twosided\"><bsdf type=\"dielectric\"/></bsdf>", "2:1",
     "twosided has no effect on what lets light through"},
    {"<bsdf type=\"diffuse\"><texture type=\"checkerboard\" name=\"reflectance\"><float name=\"colour0\" "
     "value=\"1\"/></texture></bsdf>",
     "2:70", "unknown parameter \"colour0\""},
};

}  // namespace

TEST_CASE("unknown things warn with their place; strict makes them errors") {
  LoadOptions strict;
  strict.strict = true;
  for (const Unknown& unknown : unknowns) {
    for (const bool is_strict : {false, true}) {
      const std::vector<std::string> found = problems(around(unknown.body), is_strict ? strict : LoadOptions{});
      INFO(unknown.body);
      for (const std::string& line : found) UNSCOPED_INFO(line);
      REQUIRE(found.size() == 1);
      CHECK(found[0].rfind(std::string(unknown.place) + (is_strict ? ": error: " : ": warning: "), 0) == 0);
      CHECK(found[0].find(unknown.words) != std::string::npos);
    }
  }
}

TEST_CASE("parameters of integrators count where they change the picture") {
  const auto integer = [](const char* name, int value) {
    return "<integer name=\"" + std::string(name) + "\" value=\"" + std::to_string(value) + "\"/>";
  };
  const auto told = [](const std::string& type, const std::string& inside) {
    LoadOptions strict;
    strict.strict = true;
    return problems(around("<integrator type=\"" + type + "\">" + inside + "</integrator>"), strict);
  };
  for (const char* type : {"auto", "path", "volpath", "volpathmis", "ptracer", "bdpt"})
    CHECK(told(type, integer("max_depth", -1) + integer("rr_depth", 7)).empty());
  CHECK(told("whitted", integer("max_depth", 7)).empty());
  for (const int depth : {0, 1, 2}) CHECK(told("direct", integer("max_depth", depth)).empty());
  CHECK(told("direct", integer("shading_samples", 4) + integer("emitter_samples", 4)).empty());
  CHECK(told("ao", "<float name=\"max_distance\" value=\"3\"/>").empty());
  CHECK(told("direct", integer("max_depth", -2)).size() == 1);
}

TEST_CASE("what Mitsuba takes and strahl does not need is refused by --strict neither") {
  LoadOptions strict;
  strict.strict = true;
  const std::string timeout = "<float name=\"timeout\" value=\"90\"/>";
  for (const std::string& integrator :
       {"<integrator type=\"path\">" + timeout + "</integrator>",
        "<integrator type=\"moment\"><integrator type=\"path\"/>" + timeout + "</integrator>"}) {
    const std::vector<std::string> found = problems(around(integrator), strict);
    REQUIRE(found.size() == 1);
    CHECK(found[0].find("warning: \"timeout\" has no effect; --time 90 limits the run") != std::string::npos);
  }
  CHECK(problems(around("<integrator type=\"path\"><float name=\"timeout\" value=\"-1\"/></integrator>"), strict)
            .empty());
  CHECK(problems(around("<emitter type=\"constant\"><transform name=\"to_world\"><scale value=\"2\"/></transform>"
                        "</emitter>"),
                 strict)
            .empty());
}

TEST_CASE("a reflectance outside [0, 1] is clamped with a warning, strict or not") {
  const LoadedScene loaded = load_body("<bsdf type=\"diffuse\"><rgb name=\"reflectance\" value=\"2, .5, -1\"/></bsdf>");
  CHECK(std::get<Diffuse>(loaded.scene.materials[1].bsdf).reflectance.color == Rgb{1, .5, 0});
  REQUIRE(loaded.warnings.size() == 1);
  CHECK(loaded.warnings[0].message == "\"reflectance\" is 2, 0.5, -1, outside [0, 1]; 1, 0.5, 0 is used");
}

TEST_CASE("edit distance") {
  CHECK(edit_distance("", "abc") == 3);
  CHECK(edit_distance("kitten", "sitting") == 3);
  CHECK(edit_distance("radius", "raduis") == 1);
  CHECK(did_you_mean("majr_radius", {"minor_radius", "major_radius"}) == " (did you mean \"major_radius\"?)");
  CHECK(did_you_mean("itu-radio-material", {"diffuse", "twosided"}).empty());
  CHECK(did_you_mean("zz", {"x", "y"}).empty());
}
