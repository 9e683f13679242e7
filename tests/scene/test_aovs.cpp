// SPDX-License-Identifier: MIT
// Integrator aov: what it reads of `aovs`, what it leaves out, and what renders.
#include <catch2/catch.hpp>
#include <chrono>
#include <set>

#include "scene/scene_text.h"

using namespace strahl;
using namespace strahl::test;
using Catch::Matchers::Contains;

namespace {

std::string aov(const std::string& list, const std::string& inside = "<integrator type=\"path\"/>") {
  return "<integrator type=\"aov\"><string name=\"aovs\" value=\"" + list + "\"/>" + inside + "</integrator>";
}

std::vector<NamedAov> aovs_of(const std::string& list) {
  const LoadedScene loaded = load_body(aov(list));
  CHECK(loaded.warnings.empty());
  return loaded.scene.integrator.aovs;
}

}  // namespace

TEST_CASE("every type that strahl has, and its channels") {
  const std::vector<std::pair<std::string, std::vector<std::string>>> types{{"depth", {"a.b.T"}},
                                                                            {"position", {"a.b.X", "a.b.Y", "a.b.Z"}},
                                                                            {"uv", {"a.b.U", "a.b.V"}},
                                                                            {"sh_normal", {"a.b.X", "a.b.Y", "a.b.Z"}},
                                                                            {"geo_normal", {"a.b.X", "a.b.Y", "a.b.Z"}},
                                                                            {"albedo", {"a.b.R", "a.b.G", "a.b.B"}},
                                                                            {"prim_index", {"a.b.I"}},
                                                                            {"shape_index", {"a.b.I"}}};
  std::set<Aov> all;
  for (const auto& [type, channels] : types) {
    INFO(type);
    const std::vector<NamedAov> aovs = aovs_of("a.b:" + type);
    REQUIRE(aovs.size() == 1);
    CHECK(channels_of(aovs[0]) == channels);
    all.insert(aovs[0].aov);
  }
  CHECK(all.size() == types.size());
  CHECK(aovs_of("n:sh_normal")[0].aov == Aov::normal);
  CHECK(aovs_of("i:shape_index")[0].aov == Aov::shape_id);
}

TEST_CASE("blanks, empty parts and repeated ones") {
  const std::vector<NamedAov> two{{"d", Aov::depth}, {"n", Aov::normal}};
  for (const char* list : {"d:depth,n:sh_normal", " d : depth ,, n:sh_normal , ", "d:depth n:sh_normal",
                           "d: depth n :sh_normal", "d:depth,n:sh_normal,d:depth", "\n d:depth,\n\t n:sh_normal\n"}) {
    INFO(list);
    CHECK(aovs_of(list) == two);
  }
  CHECK(aovs_of("").empty());
  // Both channels are there.
  CHECK(aovs_of("d:depth,d:position").size() == 2);
}

TEST_CASE("very many are read in no time") {
  const int count = 200000;
  std::string list;
  for (int i = 0; i < count; ++i) list += "a" + std::to_string(i) + ":depth,";
  const auto begin = std::chrono::steady_clock::now();
  CHECK(aovs_of(list + list).size() == count);
  // A quadratic one takes minutes.
  CHECK(std::chrono::steady_clock::now() - begin < std::chrono::seconds(20));
}

TEST_CASE("the integrator inside renders; the parameters of both are read without a warning") {
  const LoadedScene loaded = load_body(
      "<integrator type=\"aov\"><string name=\"aovs\" value=\"d:depth\"/>"
      "<integer name=\"samples_per_pass\" value=\"1\"/><integrator type=\"whitted\">"
      "<integer name=\"max_depth\" value=\"3\"/></integrator></integrator>");
  CHECK(loaded.warnings.empty());
  CHECK(loaded.scene.integrator.name == "whitted");
  CHECK(loaded.scene.integrator.max_depth == 3);
  CHECK(loaded.scene.integrator.aovs_where.line == 2);
}

TEST_CASE("without an integrator inside it is auto; of several the first one renders") {
  const LoadedScene none = load_body(aov("d:depth", ""));
  CHECK(none.warnings.empty());
  CHECK_FALSE(none.scene.integrator.why.empty());
  CHECK(none.scene.integrator.aovs.size() == 1);
  const std::string several = aov("d:depth", "<integrator type=\"whitted\"/>\n<integrator type=\"path\"/>");
  CHECK(load_body(several).scene.integrator.name == "whitted");
  const std::vector<std::string> found = problems(around(several));
  REQUIRE(found.size() == 1);
  CHECK_THAT(found[0], Contains("3:1: warning: the first <integrator> of integrator \"aov\" renders"));
}

TEST_CASE("aovs around each other are all written") {
  const LoadedScene loaded = load_body("<integrator type=\"aov\"><string name=\"aovs\" value=\"d:depth,u:uv\"/>" +
                                       aov("u:uv,n:sh_normal") + "</integrator>");
  CHECK(loaded.warnings.empty());
  CHECK(loaded.scene.integrator.aovs == std::vector<NamedAov>{{"u", Aov::uv}, {"n", Aov::normal}, {"d", Aov::depth}});
}

TEST_CASE("what strahl has not is told once, at its place, and left out") {
  const std::string list = "d:depth,a:dp_du,b:dp_dv,c:duv_dx,e:duv_dy,f:boundary_test";
  CHECK(load_body(aov(list)).scene.integrator.aovs == std::vector<NamedAov>{{"d", Aov::depth}});
  const std::vector<std::string> found = problems(around(aov(list)));
  REQUIRE(found.size() == 1);
  CHECK_THAT(found[0], Contains("2:24: warning: \"aovs\"") && Contains("\"a:dp_du\", \"b:dp_dv\"") &&
                           Contains("\"f:boundary_test\" are not supported yet; they are left out") &&
                           !Contains("depth"));
  const std::vector<std::string> unknown = problems(around(aov("d:dept,n:sh_normal")));
  REQUIRE(unknown.size() == 1);
  CHECK_THAT(unknown[0], Contains("2:24: warning: ") && Contains("unknown type \"dept\" (did you mean \"depth\"?)") &&
                             Contains("\"d:dept\" is left out"));
}

TEST_CASE("faulty parts are errors") {
  for (const char* part : {"depth", ":depth", "d:", ":", "a:b:depth", "d::depth"}) {
    const std::vector<std::string> found = problems(around(aov("n:sh_normal," + std::string(part))));
    REQUIRE(found.size() == 1);
    CHECK_THAT(found[0], Contains("2:24: error: \"aovs\": \"" + std::string(part) + "\" is not NAME:TYPE"));
  }
  CHECK_THAT(problems(around(aov(std::string(251, 'n') + ":depth"))).at(0), Contains("has 251 bytes"));
  CHECK(problems(around(aov(std::string(250, 'n') + ":depth"))).empty());
  const auto moment = [](std::size_t size) {
    return problems(around("<integrator type=\"moment\"><integrator type=\"path\" name=\"" + std::string(size, 'n') +
                           "\"/></integrator>"));
  };
  REQUIRE(moment(248).size() == 1);
  CHECK_THAT(moment(248)[0], Contains("2:1: error") && Contains("has 251 bytes"));
  CHECK(moment(247).empty());
}

TEST_CASE("no two have a channel in common") {
  const std::string list = "x:sh_normal,x:position,i:prim_index,i:shape_index";
  CHECK(load_body(aov(list)).scene.integrator.aovs ==
        std::vector<NamedAov>{{"x", Aov::normal}, {"i", Aov::primitive_id}});
  const std::vector<std::string> found = problems(around(aov(list)));
  REQUIRE(found.size() == 2);
  CHECK_THAT(found[0], Contains("\"x:position\" is left out: one before it has the channel x.X"));
  CHECK_THAT(found[1], Contains("\"i:shape_index\" is left out: one before it has the channel i.I"));
}

TEST_CASE("moment: the picture's, under the name of the integrator inside") {
  const LoadedScene loaded =
      load_body("<integrator type=\"moment\"><integrator type=\"whitted\" name=\"img\"/></integrator>");
  CHECK(loaded.warnings.empty());
  CHECK(loaded.scene.integrator.name == "whitted");
  CHECK(loaded.scene.integrator.aovs == std::vector<NamedAov>{{"img", Aov::xyz}, {"m2_img", Aov::xyz_squared}});
  CHECK(channels_of(loaded.scene.integrator.aovs[1]) == std::vector<std::string>{"m2_img.X", "m2_img.Y", "m2_img.Z"});
  CHECK(
      load_body("<integrator type=\"moment\"><integrator type=\"path\"/></integrator>").scene.integrator.aovs[0].name ==
      "_arg_0");
}

TEST_CASE("moment around aov: values as they are, named as Mitsuba does; aov around moment: both") {
  const std::string inside =
      "<integrator type=\"aov\" name=\"a\"><string name=\"aovs\" value=\"d:depth\"/>"
      "<integrator type=\"path\"/></integrator>";
  const LoadedScene around_aov = load_body("<integrator type=\"moment\">" + inside + "</integrator>");
  REQUIRE(around_aov.warnings.size() == 1);
  CHECK_THAT(around_aov.warnings[0].message, Contains("second moments of AOVs are not supported yet"));
  CHECK(around_aov.scene.integrator.aovs ==
        std::vector<NamedAov>{{"a.d", Aov::depth}, {"a", Aov::xyz}, {"m2_a", Aov::xyz_squared}});
  const LoadedScene in_aov =
      load_body(aov("d:depth", "<integrator type=\"moment\"><integrator type=\"path\" name=\"p\"/></integrator>"));
  CHECK(in_aov.warnings.empty());
  CHECK(in_aov.scene.integrator.aovs ==
        std::vector<NamedAov>{{"p", Aov::xyz}, {"m2_p", Aov::xyz_squared}, {"d", Aov::depth}});
}

TEST_CASE("without the parameter it warns, and --strict takes no warning") {
  const std::string none = "<integrator type=\"aov\"><integrator type=\"path\"/></integrator>";
  const std::vector<std::string> found = problems(around(none));
  REQUIRE(found.size() == 1);
  CHECK_THAT(found[0], Contains("2:1: warning: <integrator type=\"aov\"> needs \"aovs\""));
  LoadOptions strict;
  strict.strict = true;
  CHECK_THAT(problems(around(none), strict).at(0), Contains("error: "));
  CHECK(problems(around(aov("d:depth")), strict).empty());
}
