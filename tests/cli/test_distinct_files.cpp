// SPDX-License-Identifier: MIT
// No file of a command is written over another one: exit code 2 before a device is looked for (which there is not: 4).
#include <sys/stat.h>

#include <catch2/catch.hpp>
#include <cstdlib>

#include "cli/program.h"

using namespace strahl_test;
namespace fs = std::filesystem;

namespace {

const char* const other_pixel = "Pf\n1 1\n-1.0\n";

/// Runs in the folder without a device; the folder then holds what it held before.
Outcome unchanged(const Folder& folder, std::vector<std::string> arguments) {
  const std::vector<std::string> before = folder.files();
  if (arguments.front() != "compare") arguments.insert(arguments.end(), {"-d", "no-such-device"});
  std::string line;
  for (const std::string& argument : arguments) line += argument + " ";
  INFO(line);
  const Outcome outcome = folder.run(arguments);
  CHECK(folder.files() == before);
  return outcome;
}

void check_refused(const Folder& folder, const std::vector<std::string>& arguments, const std::string& says) {
  const Outcome outcome = unchanged(folder, arguments);
  INFO(says << "\n" << outcome.err);
  CHECK(outcome.code == 2);
  CHECK(contains(outcome.err, says));
}

}  // namespace

TEST_CASE("two outputs of a render are two files") {
  const Folder folder;
  folder.file("scene.xml", glowing_sphere);
  fs::create_directory(folder.path("sub"));
  fs::create_symlink("x.png", folder.path("link.png"));  // Leads to nothing yet.
  fs::create_directory_symlink("sub", folder.path("linked"));
  const std::vector<std::vector<std::string>> same{
      {"-o", "x.png", "--stats", "x.png"},
      {"-o", "x.png", "--error-map", "./x.png"},
      {"-o", "x.png", "--dump-kernel", "sub/../x.png"},
      {"-o", "x.png", "--stats", folder.path("x.png")},
      {"-o", "x.png", "--error-map", "link.png"},
      {"-o", "sub/x.png", "--stats", "linked/x.png"},
      {"--stats", "scene.png"},  // The default output.
      {"--stats", "a", "--dump-kernel", "a", "--pixel", "1,1"},
      {"-o", "x.png", "--aov", "depth,normal", "--stats", "x.depth.png"},
      {"-o", "x.pfm", "--aov", "uv", "--error-map", "x.uv.pfm"},
      {"-o", "x.png", "--frames", "12", "--time", "1s", "--stats", "x.0012.png"},
      {"-o", "x.png", "--frames", "2", "--time", "1s", "--aov", "depth", "--stats", "sub/../x.0002.depth.png"},
  };
  for (std::vector<std::string> arguments : same) {
    arguments.insert(arguments.begin(), "scene.xml");
    check_refused(folder, arguments, "are one file, \"");
  }
  const std::vector<std::vector<std::string>> different{
      {"-o", "x.png", "--stats", "x.json", "--dump-kernel", "x.cl", "--error-map", "y.png", "--spp", "4"},
      {"-o", "x.png", "--stats", "sub/x.png"},
      {"-o", "x.exr", "--aov", "depth,depth", "--stats", "x.depth.exr"},  // EXR holds its layers itself.
      {"-o", "x.png", "--frames", "11", "--time", "1s", "--stats", "x.0012.png"},
      {"-o", "x.png", "--frames", "2", "--time", "1s", "--stats", "x.png"},
      {"-o", "x.png", "--stats", "-", "--dump-kernel", "-"},
      {"-o", "x.png", "--stats", "/dev/null", "--dump-kernel", "/dev/null"},
  };
  for (std::vector<std::string> arguments : different) {
    arguments.insert(arguments.begin(), "scene.xml");
    CHECK(unchanged(folder, arguments).code == 4);
  }
}

TEST_CASE("a hard link is the file that it links to") {
  const Folder folder;
  folder.file("scene.xml", glowing_sphere);
  fs::create_hard_link(folder.path("scene.xml"), folder.path("stats.json"));
  check_refused(folder, {"scene.xml", "-o", "x.png", "--stats", "stats.json"}, "over the scene");
}

TEST_CASE("no file of the scene is written over") {
  const Folder folder;
  const std::string mesh = "v 0 0 0\nv 1 0 0\nv 0 1 0\nmtllib t.mtl\nf 1 2 3\n";
  folder.file("t.obj", mesh);
  folder.file("t.mtl", "newmtl a\n");
  folder.file("part.xml", "<scene version=\"3.0.0\"><shape type=\"sphere\"/></scene>");
  folder.file("scene.xml", R"(<scene version="3.0.0"><sensor type="perspective"/><include filename="part.xml"/>
    <shape type="obj"><string name="filename" value="t.obj"/></shape></scene>)");
  for (const char* file : {"t.obj", "t.mtl", "part.xml"})
    check_refused(folder, {"scene.xml", "-o", "x.png", "--stats", file}, "over a file of the scene");
  check_refused(folder, {"scene.xml", "-o", "x.png", "--dump-kernel", "scene.xml"}, "over the scene");
  check_refused(folder, {"t.obj", "-o", "x.png", "--stats", "./t.obj"}, "over the scene");
  check_refused(folder, {"t.obj", "-o", "x.png", "--stats", "t.mtl"}, "over a file of the scene");
  check_refused(folder, {"stress", "scene.xml", "--json", "t.obj"}, "over a file of the scene");
  check_refused(folder, {"bench", "--scene", "./scene.xml", "--json", "scene.xml"}, "over");
  check_refused(folder, {"bench", "--scene", "./scene.xml", "--json", "t.mtl"}, "over a file of the scene");
}

TEST_CASE("intersect, stress, compare, bench and tradeoff keep their files apart") {
  const Folder folder;
  folder.file("scene.xml", glowing_sphere);
  folder.file("rays.npy", "none");
  folder.file("a.pfm", std::string(other_pixel) + std::string(4, '\0'));
  folder.file("before.json", "{}");
  check_refused(folder, {"intersect", "scene.xml", "--rays", "rays.npy", "-o", "rays.npy"}, "over --rays");
  check_refused(folder, {"intersect", "scene.xml", "--rays", "rays.npy", "-o", "h.npy", "--stats", "./h.npy"},
                "are one file");
  check_refused(folder, {"intersect", "scene.xml", "--rays", "rays.npy", "-o", "h.npy", "--stats", "scene.xml"},
                "over the scene");
  check_refused(folder, {"stress", "scene.xml", "-o", "s.png", "--json", "s.png"}, "are one file");
  check_refused(folder, {"stress", "scene.xml", "--json", "scene.stress.png"}, "are one file");
  check_refused(folder, {"compare", "a.pfm", "a.pfm", "--heatmap", "a.pfm"}, "over picture A");
  check_refused(folder, {"bench", "--compare", "before.json", "--json", "before.json"}, "over --compare");
  fs::create_directory(folder.path("study"));
  fs::copy_file(folder.path("a.pfm"), folder.path("study/reference.exr"));
  check_refused(folder, {"tradeoff", "scene.xml", "-o", "study", "--reference", "study/reference.exr"},
                "over --reference");
}

TEST_CASE("hits go to a .npy file") {
  const Folder folder;
  folder.file("scene.xml", glowing_sphere);
  folder.file("rays.npy", "none");
  for (const char* name : {"h.png", "h.exr", "h", "h.npy.json"})
    check_refused(folder, {"intersect", "scene.xml", "--rays", "rays.npy", "-o", name},
                  "name a file that ends in .npy");
  CHECK(unchanged(folder, {"intersect", "scene.xml", "--rays", "rays.npy", "-o", "h.npy"}).code == 3);  // No rays.
  CHECK(unchanged(folder, {"intersect", "scene.xml", "--rays", "rays.npy", "-o", "/dev/null"}).code == 3);
}

TEST_CASE("standard output may not be the picture's file") {
  const Folder folder;
  folder.file("scene.xml", glowing_sphere);
  const std::string line = "cd " + folder.path("") + " && " + STRAHL_PROGRAM +
                           " scene.xml -o x.png --stats - -d no-such-device >x.png 2>said; test $? -eq 2";
  CHECK(std::system(line.c_str()) == 0);
  CHECK(contains(read_text(folder.path("said")), "are one file"));
}
