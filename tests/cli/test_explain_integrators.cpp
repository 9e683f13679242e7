// SPDX-License-Identifier: MIT
// `strahl explain --cost integrators`: which integrator is soonest at a given error, and what the others miss. A few
// seconds, and building six small programs.
#include <catch2/catch.hpp>
#include <map>
#include <nlohmann/json.hpp>

#include "cli/program.h"

using namespace strahl_test;
using Json = nlohmann::json;

namespace {

const std::string before =
    "<scene version=\"3.0.0\"><integrator type=\"path\"/><sensor type=\"perspective\">"
    "<transform name=\"to_world\"><lookat origin=\"0, 2, 3\" target=\"0, 0, 0\" up=\"0, 1, 0\"/></transform>"
    "<sampler type=\"independent\"/><film type=\"hdrfilm\"><integer name=\"width\" value=\"32\"/>"
    "<integer name=\"height\" value=\"32\"/></film></sensor><shape type=\"rectangle\"><transform name=\"to_world\">"
    "<scale value=\"2\"/><rotate x=\"1\" angle=\"-90\"/></transform></shape>";

/// A small lamp shines through a ball of glass onto the floor.
const std::string caustic =
    before +
    "<shape type=\"sphere\"><point name=\"center\" x=\"0\" y=\"1.2\" z=\"0\"/><float name=\"radius\" value=\"0.6\"/>"
    "<bsdf type=\"dielectric\"/></shape><shape type=\"sphere\"><point name=\"center\" x=\"0\" y=\"3\" z=\"0\"/>"
    "<float name=\"radius\" value=\"0.06\"/><emitter type=\"area\"><rgb name=\"radiance\" value=\"100\"/></emitter>"
    "</shape></scene>";

/// A box under a large lamp.
const std::string box =
    before +
    "<shape type=\"cube\"><transform name=\"to_world\"><scale value=\"0.4\"/></transform></shape>"
    "<shape type=\"rectangle\"><transform name=\"to_world\"><rotate x=\"1\" angle=\"90\"/><translate y=\"3\"/>"
    "</transform><emitter type=\"area\"/></shape></scene>";

std::map<std::string, Json> measured(const Folder& folder, const std::string& scene, const std::string& among) {
  folder.file("scene.xml", scene);
  const Outcome outcome = folder.run({"explain", "scene.xml", "--cost", "integrators", "--among", among, "--pilot",
                                      "0.3", "--json", "-d", "pocl", "--precision", "stable"});
  INFO(outcome.err);
  REQUIRE(outcome.code == 0);
  const Json report = Json::parse(outcome.out);
  CHECK_FALSE(report.contains("cost"));
  const Json& all = report.at("integrators");
  CHECK(all.at("width") == 32);
  CHECK(all.at("pilot_seconds") == 0.3);
  std::map<std::string, Json> rows;
  for (const Json& row : all.at("integrators")) rows[row.at("integrator")] = row;
  // Of the scene's own integrator.
  CHECK(all.at("rmse").get<double>() == Approx(0.01 * rows.at("path").at("mean").get<double>()));
  return rows;
}

double seconds(const Json& row, const char* end) { return row.at("seconds").at(end); }

}  // namespace

TEST_CASE("a caustic of a small lamp is had sooner from the light, and path is told to find it by chance") {
  const Folder folder;
  const std::map<std::string, Json> rows = measured(folder, caustic, "path,ptracer");
  REQUIRE(rows.size() == 2);
  const Json &path = rows.at("path"), &ptracer = rows.at("ptracer");
  CHECK(seconds(ptracer, "high") < seconds(path, "low"));
  CHECK(path.at("misses").dump().find("small lamp, found by chance") != std::string::npos);
  CHECK(ptracer.at("misses").dump().find("in mirrors and through smooth glass") != std::string::npos);
}

TEST_CASE("a box under a large lamp is had sooner from the camera; what is refused says why") {
  const Folder folder;
  const std::map<std::string, Json> rows = measured(folder, box, "path,bdpt");
  REQUIRE(rows.size() == 2);
  const Json &path = rows.at("path"), &bdpt = rows.at("bdpt");
  CHECK(seconds(path, "high") < seconds(bdpt, "low"));
  for (const Json& row : {path, bdpt}) {
    CHECK(row.at("misses").empty());
    CHECK(row.at("refused").is_null());
    CHECK(seconds(row, "low") < seconds(row, "middle"));
    CHECK(seconds(row, "middle") < seconds(row, "high"));
    CHECK(row.at("sample_seconds") > 0);
    // The same light in both: 1 % of noise and more are far from the difference that a lost bounce makes.
    CHECK(row.at("mean").get<double>() == Approx(path.at("mean").get<double>()).epsilon(0.05));
  }
  // In air of a medium bdpt is not there.
  const std::string fog = "<shape type=\"sphere\"><medium type=\"homogeneous\" name=\"interior\"/></shape></scene>";
  folder.file("fog.xml", before + fog);
  const Outcome refused = folder.run(
      {"explain", "fog.xml", "--cost", "integrators", "--among", "bdpt", "-d", "pocl", "--precision", "stable"});
  CHECK(refused.code == 0);
  CHECK(refused.out.find("bdpt      refused: integrator bdpt follows light between surfaces only") !=
        std::string::npos);
}

TEST_CASE("where the film holds too few samples for the error, that is said") {
  const Folder folder;
  folder.file("scene.xml", box);
  const std::vector<std::string> arguments{"explain", "scene.xml", "--cost", "integrators", "--among",     "path",
                                           "--pilot", "0.3",       "-d",     "pocl",        "--precision", "stable"};
  const auto also = [&](const std::vector<std::string>& more) {
    std::vector<std::string> all = arguments;
    all.insert(all.end(), more.begin(), more.end());
    const Outcome outcome = folder.run(all);
    INFO(outcome.err);
    REQUIRE(outcome.code == 0);
    return outcome.out;
  };
  const auto path = [&](const std::string& share) {
    return Json::parse(also({"--json", "--error-share", share})).at("integrators").at("integrators").at(0);
  };
  const Json far = path("1e-6");
  CHECK(far.at("is_beyond_film") == true);
  CHECK(far.at("spp").at("middle") == 1 << 21);
  CHECK(far.at("spp").at("high") == 1 << 21);
  CHECK(seconds(far, "middle") > 0);
  CHECK(contains(also({"--error-share", "1e-6"}), " s: 2.1e+06 spp, all that the film holds, are too few"));
  CHECK(path("0.05").at("is_beyond_film") == false);
}

TEST_CASE("the error is the scene's own, whichever integrators are compared", "[slow]") {
  const Folder folder;
  // Half of the light of path, which is the scene's, comes from the floor's second bounce and is not whitted's.
  folder.file("scene.xml", before + R"(<shape type="sphere"><boolean name="flip_normals" value="true"/>
    <float name="radius" value="9"/><bsdf type="diffuse"><rgb name="reflectance" value="0.9"/></bsdf></shape>
    <emitter type="point"><point name="position" x="0" y="3" z="0"/></emitter></scene>)");
  const auto all = [&](const std::string& among) {
    const Outcome outcome = folder.run({"explain", "scene.xml", "--cost", "integrators", "--among", among, "--pilot",
                                        "0.3", "--json", "-d", "pocl", "--precision", "stable"});
    INFO(outcome.err);
    REQUIRE(outcome.code == 0);
    return Json::parse(outcome.out).at("integrators");
  };
  const Json both = all("path,whitted"), without = all("whitted");
  REQUIRE(without.at("integrators").size() == 1);
  const double whitted = without.at("integrators").at(0).at("mean");
  CHECK(whitted < 0.8 * both.at("integrators").at(1).at("mean").get<double>());
  CHECK(without.at("rmse").get<double>() == Approx(both.at("rmse").get<double>()).epsilon(0.1));
}

TEST_CASE("what cannot be compared is said") {
  const Folder folder;
  folder.file("scene.xml", box);
  for (const std::string name : {"depth", "normals", "ao", "emission"}) {
    const Outcome outcome = folder.run({"explain", "scene.xml", "--cost", "integrators", "--among", name});
    CHECK(outcome.code == 2);
    CHECK(contains(outcome.err, "integrator " + name + " does not follow light"));
    CHECK(outcome.out.empty());
  }
  // Without media volpath is path.
  const Outcome same = folder.run({"explain", "scene.xml", "--cost", "integrators", "--among", "volpath", "--pilot",
                                   "0.1", "-d", "pocl", "--precision", "stable"});
  CHECK(same.code == 0);
  CHECK(contains(same.out, "volpath   refused: without media, masks and panes of thin glass it is path"));
}

TEST_CASE("samples that are not finite tell no time, which is said") {
  const Folder folder;
  folder.file("scene.xml", before +
                               "<shape type=\"sphere\"><emitter type=\"area\"><rgb name=\"radiance\" "
                               "value=\"3e38, 2, 1\"/></emitter></shape></scene>");
  const std::vector<std::string> options = {"explain", "scene.xml", "--cost", "integrators", "--among",     "path",
                                            "--pilot", "0.1",       "-d",     "pocl",        "--precision", "stable"};
  const Outcome said = folder.run(options);
  INFO(said.err);
  CHECK(said.code == 0);
  CHECK(contains(said.out, "path      not known: samples were not finite"));
  CHECK_FALSE(contains(said.out, "no noise seen"));
  std::vector<std::string> as_json = options;
  as_json.emplace_back("--json");
  const Json row = Json::parse(folder.run(as_json).out).at("integrators").at("integrators").at(0);
  CHECK(row.at("has_finite_samples") == false);
  CHECK(row.at("seconds").is_null());
}

TEST_CASE("options of the pilots mean nothing without --cost, nor options of what is not measured") {
  const Folder folder;
  folder.file("scene.xml", box);
  CHECK(folder.run({"explain", "scene.xml", "--pilot", "1"}).code == 2);
  CHECK(folder.run({"explain", "scene.xml", "--cost", "everything"}).code == 2);
  CHECK(folder.run({"explain", "scene.xml", "--cost", "integrators", "--among", "pat"}).code == 2);
  const auto refusal = [&](const char* measured, std::vector<std::string> more) {
    more.insert(more.begin(), {"explain", "scene.xml", "--cost", measured});
    const Outcome outcome = folder.run(more);
    CHECK(outcome.code == 2);
    return outcome.err;
  };
  CHECK(contains(refusal("effects", {"--pilot", "2"}), "--pilot: nothing of that is measured by --cost effects"));
  CHECK(contains(refusal("effects", {"--among", "path"}), "--among: "));
  CHECK(contains(refusal("effects", {"--error-share", "0.01"}), "--error-share: "));
  CHECK(contains(refusal("integrators", {"--rounds", "3"}), "--rounds: "));
}
