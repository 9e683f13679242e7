// SPDX-License-Identifier: MIT
// The include expander on made-up files, and on the real ones as a whole.
#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "errors.h"
#include "program/kernel_lines.h"
#include "program/kernel_source.h"

using namespace strahl;
using Catch::Contains;
using Catch::Message;
using Names = std::vector<std::string>;

namespace {

KernelFiles shape_files() {
  return {
      {"kernels/render.cl", "#include \"shapes/shape.h\"\nKERNEL\n"},
      {"shapes/shape.h",
       "// shapes\n"
       "#include \"shapes/all.h\"\n"
       "switch\n"
       "#include \"shapes/shapes.def\"  // dispatch\n"
       "done\n"},
      {"shapes/all.h", "// SPDX\n#include \"shapes/plane/plane.h\"\n#include \"shapes/sphere/sphere.h\"\n"},
      {"shapes/shapes.def", "// SHAPE(name, reals)\nSHAPE(plane, 6)  // flat\n\nSHAPE(sphere, 4)\n"},
      {"shapes/plane/plane.h", "PLANE"},
      {"shapes/sphere/sphere.h", "SPHERE\n"},
      {"features.def", "// FEATURE(NAME, \"why\")\nFEATURE(SHADOWS, \"a light // casts them\")\nFEATURE(SKY, \"\")\n"},
  };
}

std::string expand(const KernelFiles& files, const ActiveEntries& active = {}) {
  return expand_kernel(files, "kernels/render.cl", active);
}

std::string expand_one(const std::string& text) { return expand({{"kernels/render.cl", text}}); }

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

}  // namespace

TEST_CASE("Includes are expanded in place, and #line follows the file") {
  CHECK(expand(shape_files()) ==
        "#line 1 \"kernels/render.cl\"\n"
        "#line 1 \"shapes/shape.h\"\n"
        "// shapes\n"
        "#line 1 \"shapes/plane/plane.h\"\n"
        "PLANE\n"
        "#line 1 \"shapes/sphere/sphere.h\"\n"
        "SPHERE\n"
        "#line 3 \"shapes/shape.h\"\n"
        "switch\n"
        "SHAPE(plane, 6)\n"
        "SHAPE(sphere, 4)\n"
        "#line 5 \"shapes/shape.h\"\n"
        "done\n"
        "#line 2 \"kernels/render.cl\"\n"
        "KERNEL\n");
}

TEST_CASE("What is not active leaves no trace") {
  CHECK(expand(shape_files(), {{"shapes", {"sphere"}}}) ==
        "#line 1 \"kernels/render.cl\"\n"
        "#line 1 \"shapes/shape.h\"\n"
        "// shapes\n"
        "#line 1 \"shapes/sphere/sphere.h\"\n"
        "SPHERE\n"
        "#line 3 \"shapes/shape.h\"\n"
        "switch\n"
        "SHAPE(sphere, 4)\n"
        "#line 5 \"shapes/shape.h\"\n"
        "done\n"
        "#line 2 \"kernels/render.cl\"\n"
        "KERNEL\n");
}

TEST_CASE("An entry that a program does not use leaves its text unchanged bit for bit") {
  const KernelFiles before = shape_files();
  KernelFiles after = before;
  after["shapes/torus.h"] = "#include \"shapes/quartic.h\"\nTORUS\n";
  after["shapes/quartic.h"] = "QUARTIC\n";
  after["shapes/shapes.def"] = "// more\nSHAPE(torus, 7)\nSHAPE(plane, 6)\n// also\nSHAPE(sphere, 4)\n";
  after["shapes/all.h"] =
      "// longer\n\n#include \"shapes/plane/plane.h\"\n#include \"shapes/torus.h\"\n#include "
      "\"shapes/sphere/sphere.h\"\n";
  for (const std::set<std::string>& used : {std::set<std::string>{}, {"plane"}, {"plane", "sphere"}}) {
    CHECK(expand(after, {{"shapes", used}}) == expand(before, {{"shapes", used}}));
  }
  CHECK(expand(after, {{"shapes", {"torus"}}}).find("QUARTIC") != std::string::npos);
  CHECK(expand(after) != expand(before));
}

TEST_CASE("The lanes of an entry that is not active are dropped; files that are no entry stay") {
  KernelFiles files = shape_files();
  files["shapes/all_lanes.h"] =
      "#include \"shapes/sphere/sphere_lanes.h\"\n#include \"shapes/plane/plane_lanes.h\"\n#include "
      "\"shapes/block.h\"\n";
  files["shapes/all_surfaces_lanes.h"] =
      "#include \"shapes/sphere/sphere_surfaces_lanes.h\"\n#include \"shapes/plane/plane_surfaces_lanes.h\"\n";
  files["shapes/sphere/sphere_surfaces_lanes.h"] = "SPHERE_SURFACES\n";
  files["shapes/plane/plane_surfaces_lanes.h"] = "PLANE_SURFACES\n";
  files["shapes/sphere/sphere_lanes.h"] = "SPHERE_LANES\n";
  files["shapes/plane/plane_lanes.h"] = "PLANE_LANES\n";
  files["shapes/block.h"] = "BLOCK\n";
  files["kernels/render.cl"] = "#include \"shapes/all_lanes.h\"\n#include \"shapes/all_surfaces_lanes.h\"\n";
  const std::string text = expand(files, {{"shapes", {"plane"}}});
  CHECK_THAT(text, !Contains("SPHERE_LANES") && Contains("PLANE_LANES") && Contains("BLOCK"));
  CHECK_THAT(text, !Contains("SPHERE_SURFACES") && Contains("PLANE_SURFACES"));
}

TEST_CASE("What entries share stands in the text where one of them is active") {
  KernelFiles files = shape_files();
  files["shapes/roots.h"] = "ROOTS\n";
  files["shapes/corners.h"] = "CORNERS\n";
  files["shapes/all.h"] =
      "#include \"shapes/roots.h\"  // of sphere\n#include \"shapes/corners.h\"  // not of sphere\n" +
      files["shapes/all.h"];
  CHECK_THAT(expand(files, {{"shapes", {"plane"}}}), !Contains("ROOTS") && Contains("CORNERS"));
  CHECK_THAT(expand(files, {{"shapes", {"sphere"}}}), Contains("ROOTS") && !Contains("CORNERS"));
  CHECK_THAT(expand(files, {{"shapes", {}}}), !Contains("ROOTS") && !Contains("CORNERS"));
  files["shapes/all.h"] = "#include \"shapes/roots.h\"  // of torus\n";
  CHECK_THROWS_WITH(expand(files), Contains("shapes/all.h:1: shapes/shapes.def has no entry \"torus\""));
}

TEST_CASE("A feature's sections of entries and of their lists stand in the texts that have it") {
  const KernelFiles without = shape_files();
  KernelFiles files = without;
  files["shapes/glow.h"] = "GLOW\n";
  files["shapes/all.h"] = "#if HAS_GLOW\n#include \"shapes/glow.h\"  // of sphere\n#endif\n" + files["shapes/all.h"];
  files["shapes/sphere/sphere.h"] += "\n#if HAS_GLOW\n#if TIER_FAST\nDIM\n#else\nBRIGHT\n#endif\n#endif\n";
  const auto text = [&](const ActiveFeatures& features, const ActiveEntries& active = {}) {
    return expand_kernel(files, "kernels/render.cl", active, features);
  };
  CHECK(text({{"GLOW", false}}) == expand(without));
  for (const ActiveFeatures& on : {ActiveFeatures{}, ActiveFeatures{{"GLOW", true}}}) {
    CHECK_THAT(text(on), Contains("#line 1 \"shapes/glow.h\"\nGLOW\n") && !Contains("HAS_GLOW"));
    CHECK_THAT(text(on), Contains("SPHERE\n\n\n#if TIER_FAST\nDIM\n#else\nBRIGHT\n#endif\n#line"));
  }
  CHECK(text({}, {{"shapes", {"plane"}}}) == expand(without, {{"shapes", {"plane"}}}));
  // In the middle of a file line numbers stay; other files are the compiler's.
  files["shapes/sphere/sphere.h"] = "#if HAS_GLOW\nA\n#endif\nSPHERE\n";
  CHECK_THAT(text({{"GLOW", false}}), Contains("#line 1 \"shapes/sphere/sphere.h\"\n\n\n\nSPHERE\n"));
  files["kernels/render.cl"] += "#if HAS_GLOW\nKERNEL\n#endif\n";
  CHECK_THAT(text({{"GLOW", false}}), Contains("#if HAS_GLOW\nKERNEL\n#endif\n"));
  files["shapes/sphere/sphere.h"] = "#if HAS_GLOW\nA\n#else\nB\n#endif\n";
  CHECK_THROWS_WITH(text({}), Contains("shapes/sphere/sphere.h:3: a feature's section has no #else"));
  files["shapes/sphere/sphere.h"] = "#if HAS_GLOW\nA\n";
  CHECK_THROWS_WITH(text({}), Contains("shapes/sphere/sphere.h:2: a feature's section has no #endif"));
}

TEST_CASE("A direct include of an entry that is not active leaves the line numbers right") {
  KernelFiles files = shape_files();
  files["kernels/render.cl"] = "#include \"shapes/plane/plane.h\"\nnext\n";
  CHECK(expand(files, {{"shapes", {}}}) == "#line 1 \"kernels/render.cl\"\n\nnext\n");
}

TEST_CASE("A file without guard is expanded every time, a guarded one until it stands there unconditionally") {
  KernelFiles files = {
      {"lanes.h", "#include \"portable.h\"\nLANES_BODY\n"},
      {"portable.h", "// once\n#ifndef P_H\n#define P_H\n#if X\nA\n#else\nPORTABLE\n#endif\n#endif\n"},
      {"kernels/render.cl", "#include \"lanes.h\"\n#include \"lanes.h\"\n"},
  };
  CHECK(count(expand(files), "LANES_BODY") == 2);
  CHECK(count(expand(files), "PORTABLE") == 1);

  files["kernels/render.cl"] = "#ifdef HOST\n#include \"lanes.h\"\n#else\n#include \"lanes.h\"\n#endif\n";
  CHECK(count(expand(files), "PORTABLE") == 2);  // the first may be dead text
  files["kernels/render.cl"] += "#include \"lanes.h\"\n#include \"lanes.h\"\n";
  CHECK(count(expand(files), "PORTABLE") == 3);

  files["portable.h"] = "#pragma once\nPORTABLE\n";
  CHECK_THROWS_WITH(expand(files), Contains("portable.h:1: kernel files use an include guard"));
}

TEST_CASE("Include guards are told from other conditionals") {
  const auto guard = [](const std::string& text) { return include_guard(kernel_lines(text)); };
  CHECK(guard("// x\n#ifndef A\n#define A\nb\n#if c\n#endif\n#endif  // A\n\n") == "A");
  CHECK(guard("#ifndef A\n#define B\n#endif\n").empty());
  CHECK(guard("#ifndef A\n#define A\n#else\n#endif\n").empty());
  CHECK(guard("#ifndef A\n#define A\n#endif\nb\n").empty());
  CHECK(guard("#ifndef A\n#define A\n#endif\n#if b\n#endif\n").empty());
  CHECK(guard("x\n#ifndef A\n#define A\n#endif\n").empty());
}

TEST_CASE("Directives in comments are no directives, and comments in strings are no comments") {
  CHECK_NOTHROW(expand_one("// #include \"a.h\"\n/* x\n#include \"a.h\"\n*/ int a; /* y */\n"));
  CHECK(kernel_lines("a /* b */ c // d\n\"/*\" e\n'\"' // f").at(0).bare == "a   c");
  CHECK(kernel_lines("a\n\"/*\\\"//\" e\n").at(1).bare == "\"/*\\\"//\" e");
  CHECK(kernel_lines("'\"' // f").at(0).bare == "'\"'");
  CHECK(expand_one("#include <cmath>\n") == "#line 1 \"kernels/render.cl\"\n#include <cmath>\n");
}

TEST_CASE("Faults name the file and the line") {
  CHECK_THROWS_MATCHES(expand_one("a\n#include \"b.h\"\n"), std::logic_error,
                       Message("kernels/render.cl:2: includes \"b.h\", which is not below cl/ (includes are relative "
                               "to cl/)"));
  const KernelFiles circle = {
      {"kernels/render.cl", "#include \"a.h\"\n"}, {"a.h", "\n#include \"b.h\"\n"}, {"b.h", "#include \"a.h\"\n"}};
  CHECK_THROWS_MATCHES(expand(circle), std::logic_error,
                       Message("b.h:1: includes \"a.h\", which is being included: kernels/render.cl > a.h > b.h"));
  CHECK_THROWS_AS(expand_kernel(shape_files(), "kernels/none.cl", {}), std::logic_error);
  CHECK_THROWS_WITH(expand(shape_files(), {{"shapes", {"torus"}}}), "shapes/shapes.def has no entry \"torus\"");
  CHECK_THROWS_WITH(expand(shape_files(), {{"lights", {}}}), "there is no list lights/lights.def");
  KernelFiles files = shape_files();
  files["shapes/shapes.def"] = "SHAPE(plane, 6)\n#undef SHAPE\n";
  CHECK_THROWS_WITH(expand(files), Contains("shapes/shapes.def:2: a list holds comments and entries"));
  files = shape_files();
  files["shapes/all.h"] += "int a;\n";
  CHECK_THROWS_WITH(expand(files), Contains("shapes/all.h:4: a list file holds comments and includes only"));
}

TEST_CASE("Lists name their entries in file order") {
  CHECK(list_entries(shape_files(), "shapes") == Names{"plane", "sphere"});
  CHECK(list_folders(shape_files()) == Names{"shapes"});
  CHECK_THROWS_WITH(list_entries(shape_files(), "lights"), "there is no list lights/lights.def");
  CHECK(list_entries({{"lights/lights.def", "LIGHT(point)\nLIGHT ( sun , (1, 2) )\n"}}, "lights") ==
        Names{"point", "sun"});
  const auto features = list_features(shape_files());
  REQUIRE(features.size() == 2);
  CHECK(features[0] == std::pair<std::string, std::string>("SHADOWS", "a light // casts them"));
  CHECK(features[1].first == "SKY");
}

TEST_CASE("The embedded files are those of the source tree") {
  unsetenv("STRAHL_KERNEL_DIR");
  const KernelFiles embedded = kernel_files();
  REQUIRE(embedded.contains("portable.h"));
  setenv("STRAHL_KERNEL_DIR", STRAHL_SOURCE_DIR "/cl", 1);
  const KernelFiles on_disk = kernel_files();
  CHECK(on_disk.size() == embedded.size());
  for (const auto& [path, text] : on_disk) {
    INFO(path);
    CHECK((embedded.contains(path) && embedded.at(path) == text));
  }
  setenv("STRAHL_KERNEL_DIR", STRAHL_SOURCE_DIR "/nowhere", 1);
  CHECK_THROWS_AS(kernel_files(), Error);
  setenv("STRAHL_KERNEL_DIR", STRAHL_SOURCE_DIR "/docs", 1);
  CHECK_THROWS_WITH(kernel_files(), Catch::Contains("STRAHL_KERNEL_DIR") && Catch::Contains("has no features.def"));
  unsetenv("STRAHL_KERNEL_DIR");
}

TEST_CASE("Every kernel of the source tree expands, with all entries and with none") {
  ActiveEntries none;
  for (const std::string& folder : list_folders()) none[folder] = {};
  for (const auto& [path, text] : kernel_files()) {
    INFO(path);
    if (path.ends_with(".cl")) {
      CHECK_NOTHROW(expand_kernel(path, {}));
      CHECK_NOTHROW(expand_kernel(path, none));
    }
  }
}
