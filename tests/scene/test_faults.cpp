// SPDX-License-Identifier: MIT
// Every structural fault: an error at its line and column, and all of a file at once.
#include <sys/stat.h>

#include <catch2/catch.hpp>
#include <thread>

#include "scene/scene_text.h"

using namespace strahl;
using namespace strahl::test;

namespace {

struct Fault {
  const char* body;  ///< From line 2 on.
  const char* place;
  const char* words;
};

/// Exactly one problem, an error, at the place and with the words.
void check_fault(const std::string& text, const std::string& place, const std::string& words,
                 const LoadOptions& options = {}) {
  const std::vector<std::string> found = problems(text, options);
  INFO(text);
  for (const std::string& line : found) UNSCOPED_INFO(line);
  REQUIRE(found.size() == 1);
  CHECK(found[0].rfind(place + ": error: ", 0) == 0);
  CHECK(found[0].find(words) != std::string::npos);
}

const char* const triangle_ply =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 0\n"
    "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n";

}  // namespace

TEST_CASE("faults of shapes") {
  const Fault faults[] = {
      {"<shape type=\"sphere\"><float name=\"radius\" value=\"0\"/></shape>", "2:22", "greater than 0"},
      {"<shape type=\"sphere\">\n  <float name=\"radius\" value=\"-1\"/></shape>", "3:3", "\"radius\" is -1"},
      {"<shape type=\"sphere\"><float name=\"radius\" value=\"nan\"/></shape>", "2:22", "not finite"},
      {"<shape type=\"sphere\"><float name=\"radius\" value=\"1e999\"/></shape>", "2:22", "not finite"},
      {"<shape type=\"sphere\"><float name=\"radius\" value=\"1m\"/></shape>", "2:22", "not a number"},
      {"<shape type=\"sphere\"><string name=\"radius\" value=\"1\"/></shape>", "2:22", "must be a <float>"},
      {"<shape type=\"sphere\"><point name=\"center\" x=\"inf\" y=\"0\" z=\"0\"/></shape>", "2:22", "not finite"},
      {"<shape type=\"sphere\"><point name=\"center\" x=\"1\" y=\"0\"/></shape>", "2:22", "needs z"},
      {"<shape type=\"sphere\"><point name=\"center\" value=\"1 2\"/></shape>", "2:22", "2 components"},
      {"<shape type=\"sphere\"><float name=\"radius\" value=\"1\"/><float name=\"radius\" value=\"1\"/></shape>",
       "2:54", "given twice"},
      {"<shape type=\"sphere\"><float name=\"radius\"/></shape>", "2:22", "needs the attribute value"},
      {"<shape><float name=\"radius\" value=\"1\"/></shape>", "2:1", "needs the attribute type"},
      {"<shape type=\"sphere\"><transform name=\"to_world\"><scale x=\"2\"/></transform></shape>", "2:22", "distorts"},
      {"<shape type=\"sphere\"><transform name=\"to_world\"><matrix value=\"1 .1 0 0 1 0 0 0 1\"/></transform></shape>",
       "2:22", "distorts"},
      {"<shape type=\"cylinder\"><transform name=\"to_world\"><scale y=\"2\"/></transform></shape>", "2:24",
       "distorts"},
      {"<shape type=\"cylinder\"><point name=\"p1\" value=\"0\"/></shape>", "2:24", "same point"},
      {"<shape type=\"box\"><point name=\"min\" value=\"1\"/><point name=\"max\" x=\"2\" y=\"0\" z=\"2\"/></shape>",
       "2:48", "less than min"},
      {"<shape type=\"box\"><point name=\"min\" value=\"1\"/></shape>", "2:1", "needs the point \"max\""},
      {"<shape type=\"plane\"><vector name=\"normal\" value=\"0\"/></shape>", "2:21", "normal is zero"},
      {"<shape type=\"plane\"><vector name=\"u\" value=\"1\"/><vector name=\"v\" value=\"2\"/></shape>", "2:21",
       "parallel"},
      {"<shape type=\"plane\"><point name=\"point\" value=\"1\"/><float name=\"d\" value=\"2\"/></shape>", "2:52",
       "second time"},
      {"<shape type=\"triangle\"><point name=\"p0\" value=\"0\"/><point name=\"p1\" value=\"1\"/><point name=\"p2\" "
       "value=\"2\"/></shape>",
       "2:1", "lie on a line"},
      {"<shape type=\"obj\"/>", "2:1", "needs the string \"filename\""},
      {"<shape type=\"ply\"><string name=\"filename\" value=\"none.ply\"/></shape>", "2:19", "cannot read"},
      {"<shape type=\"sphere\"><ref id=\"clya\"/></shape><bsdf type=\"diffuse\" id=\"clay\"/>", "2:22",
       "did you mean \"clay\"?"},
      {"<shape type=\"sphere\" id=\"a\"/>\n<shape type=\"disk\" id=\"a\"/>", "3:1", "duplicate id \"a\""},
      {"<bsdf type=\"twosided\" id=\"a\"><ref id=\"a\"/></bsdf>", "2:1", "contains itself"},
      {"<bsdf type=\"twosided\"/>", "2:1", "needs a <bsdf> inside"},
  };
  for (const Fault& fault : faults) check_fault(around(fault.body), fault.place, fault.words);
}

TEST_CASE("faults of transforms") {
  const Fault steps[] = {
      {"<scale x=\"0\"/>", "3:1", "singular"},
      {"<matrix value=\"1 2 3 2 4 6 0 0 1\"/>", "3:1", "singular"},
      {"<matrix value=\"1 0 0 0 1 0 0 0 1e-200\"/>", "3:1", "the shortest 1e-200, which is nothing beside it"},
      {"<matrix value=\"1e-310 0 0 0 1e-310 0 0 0 1e-310\"/>", "3:1", "too small to be inverted"},
      {"<matrix value=\"1 0 1 0 1 1 0 0 0\"/>", "3:1", "in one plane"},
      {"<scale value=\"1 1 1e-16\"/>", "2:23", "the composed transform is singular: the longest"},
      {"<matrix value=\"1 2 3\"/>", "3:1", "9 or 16"},
      {"<matrix value=\"1 0 0 0 0 1 0 0 0 0 1 0 0 0 1 1\"/>", "3:1", "last row"},
      {"<rotate angle=\"3\"/>", "3:1", "needs either value or x, y, z"},
      {"<rotate value=\"0 0 0\" angle=\"3\"/>", "3:1", "needs an axis"},
      {"<translate x=\"nan\"/>", "3:1", "not finite"},
      {"<translate x=\"1\" value=\"1\"/>", "3:1", "either value or"},
      {"<lookat origin=\"1,2,3\" target=\"1,2,3\" up=\"0,1,0\"/>", "3:1", "same point"},
      {"<lookat origin=\"0,0,0\" target=\"0,3,0\" up=\"0,1,0\"/>", "3:1", "parallel"},
      {"<scale value=\"1e200\"/><scale value=\"1e200\"/>", "2:23", "range of double"},
  };
  for (const Fault& step : steps)
    check_fault(around(std::string("<shape type=\"rectangle\"><transform name=\"to_world\">\n") + step.body +
                       "</transform></shape>"),
                std::string(step.place) == "2:23" ? "2:25" : step.place, step.words);
}

TEST_CASE("faults of lights, camera, film, sampler, integrator") {
  const Fault faults[] = {
      {"<emitter type=\"constant\"><rgb name=\"radiance\" value=\"-1\"/></emitter>", "2:26", "negative"},
      {"<emitter type=\"constant\"><rgb name=\"radiance\" value=\"#12345\"/></emitter>", "2:26", "not a colour"},
      {"<emitter type=\"constant\"/><emitter type=\"constant\"/>", "2:27", "one constant"},
      {"<emitter type=\"directional\"><vector name=\"direction\" value=\"0\"/></emitter>", "2:29", "direction is zero"},
      {"<integrator type=\"direct\"/><integrator type=\"depth\"/>", "2:28", "one <integrator>"},
      {"<integrator type=\"direct\"><integer name=\"max_depth\" value=\"-2\"/></integrator>", "2:27", "[-1, "},
      {"<integrator type=\"direct\"><boolean name=\"hide_emitters\" value=\"yes\"/></integrator>", "2:27",
       "true or false"},
  };
  for (const Fault& fault : faults) check_fault(around(fault.body), fault.place, fault.words);
  const Fault sensors[] = {
      {"<float name=\"fov\" value=\"180\"/>", "2:1", "between 0 and 180"},
      {"<float name=\"fov\" value=\"0\"/>", "2:1", "between 0 and 180"},
      {"<float name=\"fov\" value=\"40\"/><string name=\"fov_axis\" value=\"z\"/>", "2:31", "none of x, y"},
      {"<float name=\"fov\" value=\"40\"/><string name=\"focal_length\" value=\"50mm\"/>", "2:31", "not both"},
      {"<string name=\"focal_length\" value=\"0mm\"/>", "2:1", "not a focal length"},
      {"<float name=\"near_clip\" value=\"2\"/><float name=\"far_clip\" value=\"1\"/>", "2:36",
       "greater than near_clip"},
      {"<film type=\"hdrfilm\"><integer name=\"width\" value=\"0\"/></film>", "2:22", "[1, 65536]"},
      {"<film type=\"hdrfilm\"><integer name=\"height\" value=\"65537\"/></film>", "2:22", "[1, 65536]"},
      {"<film type=\"hdrfilm\"><integer name=\"width\" value=\"1.5\"/></film>", "2:22", "not a whole number"},
      {"<film type=\"hdrfilm\"><integer name=\"crop_width\" value=\"769\"/></film>", "2:22", "beyond the width"},
      {"<film type=\"hdrfilm\"><rfilter type=\"box\"><float name=\"radius\" value=\"0\"/></rfilter></film>", "2:42",
       "greater than 0"},
      {"<sampler type=\"independent\"><integer name=\"sample_count\" value=\"0\"/></sampler>", "2:29", "[1, "},
  };
  for (const Fault& fault : sensors)
    check_fault(
        "<scene version=\"3.0.0\"><sensor type=\"perspective\">\n" + std::string(fault.body) + "</sensor></scene>",
        fault.place, fault.words);
}

TEST_CASE("malformed files") {
  check_fault("<scene version=\"3.0.0\">\n  <shape type=\"sphere\">\n</scene>", "3:3", "malformed XML");
  check_fault("", "1:1", "malformed XML");
  check_fault("<scene version=\"3.0.0\"/>\n<scene version=\"3.0.0\"/>", "2:1", "one root");
  check_fault("<sceen version=\"3.0.0\"/>", "1:1", "the root is <sceen>");
  check_fault("\xFF\xFE<", "0:0", "UTF-16");
  CHECK_THROWS_AS(load_scene("no/such/scene.xml"), SceneError);
}

TEST_CASE("columns count characters, not bytes") {
  check_fault(
      around("<!-- \xC3\xA4\xE2\x82\xAC --><shape type=\"sphere\"><float name=\"radius\" value=\"0\"/></shape>"),
      "2:33", "greater than 0");
}

TEST_CASE("columns are those of the file, not of what parsing leaves of it") {
  const std::string before = "<bsdf type=\"diffuse\" id=\"&amp;&#252;&lt;\"/>";
  const std::string shape = "<shape type=\"sphere\"><float name=\"radius\" value=\"0\"/></shape>";
  check_fault(around(before + shape), "2:65", "greater than 0");
  check_fault(around("<!-- \xC3\xA4 -->" + before + shape), "2:75", "greater than 0");
  check_fault(around("<bsdf type=\"diffuse\"\r\nid=\"\xC3\xA4\n&gt;\"/>" + shape), "4:29", "greater than 0");
  check_fault(around("<bsdf type=\"diffuse\" id=\"\xC3\xA4&#228;\"/></shape>"), "2:38", "malformed XML");
}

TEST_CASE("elements nested too deeply are refused, however deeply") {
  for (const std::size_t depth : {std::size_t{64}, std::size_t{200000}}) {
    std::string text, end;
    for (std::size_t i = 0; i < depth; ++i) text += "<bsdf type=\"twosided\">", end += "</bsdf>";
    CHECK(problems(around(text + end)).back() == "2:1387: error: elements are nested deeper than 64");
  }
}

TEST_CASE("a scene comes through a pipe, whatever its length") {
  const SceneFolder folder;
  std::string body;
  for (int i = 0; i < 5000; ++i) body += "<shape type=\"sphere\"/>\n";
  REQUIRE(body.size() > 100000);
  const std::string path = folder.path("scene.xml");
  std::filesystem::create_directories(std::filesystem::path(path).parent_path());
  REQUIRE(mkfifo(path.c_str(), 0600) == 0);
  const std::jthread writer([&] { std::ofstream(path) << around(body); });
  const LoadedScene loaded = load_scene(path);
  REQUIRE(loaded.scene.shapes.size() == 5000);
  CHECK(loaded.scene.shapes.back().where.line == 5001);
}

TEST_CASE("mesh files name their own place") {
  const SceneFolder folder;
  folder.write("empty.ply", triangle_ply);
  folder.write("bad.obj", "v 0 0 0\nv 1 0 0\nf 1 2 9\n");
  const std::string scene = folder.write(
      "scene.xml", around("<shape type=\"ply\"><string name=\"filename\" value=\"empty.ply\"/></shape>\n<shape "
                          "type=\"obj\"><string name=\"filename\" value=\"bad.obj\"/></shape>"));
  try {
    static_cast<void>(load_scene(scene));
    FAIL("both meshes are broken");
  } catch (const SceneError& error) {
    const std::string all = error.what();
    CHECK(all.find("empty.ply") != std::string::npos);
    CHECK(all.find("bad.obj:3") != std::string::npos);
  }
}

TEST_CASE("all problems at once, in file order") {
  const std::vector<std::string> found = problems(
      "<scene version=\"3.0.0\">\n<sensor type=\"perspective\"><float name=\"fov\" value=\"0\"/></sensor>\n"
      "<shape type=\"sphere\"><float name=\"radus\" value=\"1\"/><float name=\"radius\" value=\"$r\"/></shape>\n"
      "<emitter type=\"point\"><point name=\"position\" value=\"x\"/></emitter>\n<shape type=\"spher\"/>\n</scene>");
  REQUIRE(found.size() == 5);
  CHECK(found[0].rfind("2:28: error: fov", 0) == 0);
  CHECK(found[1] ==
        "3:22: warning: unknown parameter \"radus\" of <shape type=\"sphere\"> (did you mean \"radius\"?); it is "
        "ignored");
  CHECK(found[2].rfind("3:53: error: $r is not defined", 0) == 0);
  CHECK(found[3].rfind("4:23: error: \"x\"", 0) == 0);
  CHECK(found[4] == "5:1: warning: unknown shape \"spher\" (did you mean \"sphere\"?); it is left out");
}

TEST_CASE("references make a small file neither an endless nor an exponential walk") {
  const auto blend = [](const std::string& id, const std::string& a, const std::string& b) {
    return "<bsdf type=\"blendbsdf\" id=\"" + id + "\"><ref id=\"" + a + "\"/><ref id=\"" + b + "\"/></bsdf>";
  };
  std::string twice = "<bsdf type=\"diffuse\" id=\"b0\"/>", chain = twice;
  for (int i = 1; i <= 200; ++i) {
    const std::string id = "b" + std::to_string(i), before = "b" + std::to_string(i - 1);
    twice += blend(id, before, before);
  }
  for (int i = 1; i <= 20000; ++i) chain += blend("b" + std::to_string(i), "b" + std::to_string(i - 1), "b0");
  const std::string shape = "<shape type=\"sphere\"><bsdf type=\"twosided\"><ref id=\"b200\"/></bsdf></shape>";
  CHECK(load_body(twice + shape).scene.materials.size() == 203);
  const std::vector<std::string> deep = problems(around(chain + shape));
  REQUIRE(deep.size() == 1);
  CHECK(deep[0].find("error: materials are nested deeper than 256") != std::string::npos);

  const auto medium = [](const std::string& phases) {
    return around("<shape type=\"sphere\"><medium type=\"homogeneous\" name=\"interior\">" + phases +
                  "</medium></shape>");
  };
  const std::vector<std::string> cycle =
      problems(medium("<phase type=\"blendphase\" id=\"p\"><ref id=\"p\"/><ref id=\"p\"/></phase>"));
  REQUIRE(!cycle.empty());
  CHECK(cycle[0].find("error: a blendphase contains itself") != std::string::npos);
}
