// SPDX-License-Identifier: MIT
// Scenes of people who mean no good: what they can read, what they can make a terminal do, what they can make it cost.
#include <sys/stat.h>

#include <catch2/catch.hpp>
#include <chrono>
#include <filesystem>

#include "cli/printable.h"
#include "cli/program.h"

using namespace strahl_test;
namespace fs = std::filesystem;

namespace {

std::string scene_with(const std::string& inside) {
  return "<scene version=\"3.0.0\"><integrator type=\"direct\"/>" + inside + "</scene>\n";
}

const std::string triangle =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
    "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

std::string mesh(const std::string& file) {
  return "<shape type=\"ply\"><string name=\"filename\" value=\"" + file + "\"/></shape>";
}

}  // namespace

TEST_CASE("--root confines what a scene reads, links resolved") {
  const Folder folder;
  fs::create_directories(folder.path("mine/meshes"));
  fs::create_directories(folder.path("mine-too"));
  for (const char* name : {"outside.ply", "mine/meshes/inside.ply", "mine-too/beside.ply"}) folder.file(name, triangle);
  fs::create_symlink("../outside.ply", folder.path("mine/out.ply"));
  fs::create_symlink("meshes/inside.ply", folder.path("mine/in.ply"));
  fs::create_symlink("..", folder.path("mine/up"));
  const auto explained = [&](const std::string& file, const std::string& root = "mine") {
    folder.file("mine/s.xml", scene_with(mesh(file)));
    return folder.run({"explain", "mine/s.xml", "--root", root});
  };
  for (const char* file : {"meshes/inside.ply", "in.ply", "up/mine/in.ply"}) {
    INFO(file);
    CHECK(explained(file).code == 0);
  }
  for (const std::string& file : {std::string("../outside.ply"), std::string("out.ply"), std::string("up/outside.ply"),
                                  folder.path("outside.ply"), std::string("../mine-too/beside.ply")}) {
    INFO(file);
    const Outcome outcome = explained(file);
    CHECK(outcome.code == 3);
    CHECK(contains(outcome.err, "it lies outside of --root"));
  }
  CHECK(explained("../outside.ply", ".").code == 0);
  REQUIRE(mkfifo(folder.path("mine/pipe.ply").c_str(), 0600) == 0);
  CHECK(contains(explained("pipe.ply").err, "it is a pipe"));
  CHECK(explained("../outside.ply", "none").code == 2);
  folder.file("mine/s.xml", scene_with("<include filename=\"../t.xml\"/>"));
  folder.file("t.xml", scene_with(""));
  CHECK(contains(folder.run({"explain", "mine/s.xml", "--root", "mine"}).err, "it lies outside of --root"));
  CHECK(contains(folder.run({"explain", "t.xml", "--root", "mine"}).err, "it lies outside of --root"));
  folder.file("mine/s.xml", scene_with("<bsdf type=\"diffuse\"><spectrum name=\"reflectance\" filename=\"" +
                                       folder.path("t.spd") + "\"/></bsdf>"));
  folder.file("t.spd", "400 0.5\n700 0.5\n");
  CHECK(contains(folder.run({"explain", "mine/s.xml", "--root", "mine"}).err, "it lies outside of --root"));
  CHECK(folder.run({"explain", "mine/s.xml"}).code == 0);
}

TEST_CASE("what a scene is called does not reach the terminal raw") {
  const Folder folder;
  folder.file("s.xml", scene_with("<shape type=\"ply\" id=\"a\"><string name=\"filename\" "
                                  "value=\"&#27;]0;title&#7;&#10;strahl: error: forged &#155;2J.ply\"/></shape>"
                                  "<shape type=\"&#27;[2J\"/>"));
  const Outcome outcome = folder.run({"explain", "s.xml"});
  CHECK(outcome.code == 3);
  CHECK(outcome.err.find('\x1b') == std::string::npos);
  CHECK(outcome.err.find('\x07') == std::string::npos);
  CHECK(outcome.err.find("\xc2\x9b") == std::string::npos);
  CHECK(contains(outcome.err, "\\x1b"));
  CHECK(contains(outcome.err, "title\\x07\\nstrahl: error: forged"));
  using strahl::cli::printable;
  CHECK(printable("a\tb\nc") == "a\tb\nc");
  CHECK(printable("\r\x7f\xc2\x9b"
                  "\xc3\xa4") == "\\x0d\\x7f\\x9b\xc3\xa4");
}

TEST_CASE("small files do not become large ones") {
  const Folder folder;
  const auto start = std::chrono::steady_clock::now();
  std::string bomb = "<!DOCTYPE scene [<!ENTITY a0 \"aaaaaaaaaa\">";
  for (int i = 1; i < 12; ++i) {
    const std::string before = "&a" + std::to_string(i - 1) + ";";
    bomb += "<!ENTITY a" + std::to_string(i) + " \"";
    for (int k = 0; k < 10; ++k) bomb += before;
    bomb += "\">";
  }
  folder.file("bomb.xml", bomb + "]>" + scene_with("<string name=\"x\" value=\"&a11;\"/>"));
  CHECK(folder.run({"explain", "bomb.xml"}).signal == 0);

  std::string nested;
  for (int i = 0; i < 1000000; ++i) nested += "<a>";
  folder.file("nested.xml", "<scene version=\"3.0.0\">" + nested);
  CHECK(folder.run({"explain", "nested.xml"}).code == 3);
  std::string closed = nested;
  for (int i = 0; i < 1000000; ++i) closed += "</a>";
  folder.file("closed.xml", "<scene version=\"3.0.0\">" + closed + "</scene>");
  const Outcome deep = folder.run({"explain", "closed.xml"});
  CHECK(deep.code == 3);
  CHECK(contains(deep.err, "nested deeper"));

  // Counts that the file does not have the bytes for.
  const std::string head =
      "ply\nformat binary_little_endian 1.0\nelement vertex 1000000000\nproperty float x\n"
      "property float y\nproperty float z\nelement face 1000000000\n"
      "property list uint int vertex_indices\nend_header\n";
  folder.file("huge.ply", head + std::string(100, '\1'));
  CHECK(folder.run({"explain", "huge.ply"}).code == 3);
  folder.file("list.ply",
              "ply\nformat binary_little_endian 1.0\nelement vertex 0\nproperty float x\nproperty float y\n"
              "property float z\nelement face 1\nproperty list uint int vertex_indices\nend_header\n" +
                  std::string("\xff\xff\xff\xff", 4) + std::string(100, '\1'));
  CHECK(folder.run({"explain", "list.ply"}).code == 3);
  folder.file("huge.obj", "v 0 0 0\nf 1000000000 -1000000000 1\n");
  CHECK(folder.run({"explain", "huge.obj"}).code == 3);
  // Films and repeats.
  folder.file("film.xml", scene_with("<sensor type=\"perspective\"><film type=\"hdrfilm\"><integer name=\"width\" "
                                     "value=\"1000000000\"/></film></sensor>"));
  CHECK(folder.run({"explain", "film.xml"}).code == 3);
  folder.file("self.xml", scene_with("<include filename=\"self.xml\"/>"));
  CHECK(folder.run({"explain", "self.xml"}).code == 3);
  CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(60));
}
