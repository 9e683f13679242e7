// SPDX-License-Identifier: MIT
// OBJ files that must be refused, each with its place.
#include "scene_mesh/temp_folder.h"

namespace strahl {
namespace {

using test::error_of;
using test::TempFolder;

const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

TEST_CASE("indices out of range are errors, all of them") {
  const TempFolder folder;
  CHECK(error_of(folder.write("a.obj", triangle + "f 1 2 0\nf 1 2 3\nf 4 1 -4\n")) ==
        "a.obj:4:7: error: vertex index 0: OBJ counts from 1\n"
        "a.obj:6:3: error: vertex index 4 is out of range: there are 3\n"
        "a.obj:6:7: error: vertex index -4 is out of range: there are 3 so far\n");
  CHECK(error_of(folder.write("a.obj", triangle + "vt 0 0\nvn 0 0 1\nf 1/2/1 2/1/9 3/1/1\n")) ==
        "a.obj:6:3: error: texture coordinate index 2 is out of range: there are 1\n"
        "a.obj:6:9: error: normal index 9 is out of range: there are 1\n");
  CHECK(error_of(folder.write("a.obj", triangle + "f 1 2 99999999999999999999999\n")) ==
        "a.obj:4:7: error: vertex index 9223372036854775807 is out of range: there are 3\n");
  CHECK(error_of(folder.write("a.obj", triangle + "f 1 2 -9223372036854775808\n")).starts_with("a.obj:4:7: error: "));
}

TEST_CASE("numbers that are not finite are errors where a face uses them") {
  const TempFolder folder;
  for (const char* bad : {"nan", "-nan", "inf", "1.#IND", "1e999", "3.1+e2", "1,5", "0x10", "--1", "+-1", "1e", "x"}) {
    const std::string text = std::string("v 0 ") + bad + " 0\nv 1 0 0\nv 0 1 0\nf 3 2 1\nf 1 2 3\n";
    CHECK(error_of(folder.write("a.obj", text)) ==
          "a.obj:1:5: error: vertex 1 is not made of finite numbers, and the face in line 4 uses it\n");
  }
  CHECK(error_of(folder.write("a.obj", "v 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")) ==
        "a.obj:1:1: error: vertex 1 is not made of finite numbers, and the face in line 4 uses it\n");
  CHECK(error_of(folder.write("a.obj", triangle + "vn 0 nan 0\nvt inf 0\nf 1/1/1 2/1/1 3/1/1\n")) ==
        "a.obj:4:6: error: normal 1 is not made of finite numbers, and the face in line 6 uses it\n"
        "a.obj:5:4: error: texture coordinate 1 is not made of finite numbers, and the face in line 6 uses it\n");
}

TEST_CASE("a mesh without triangles is an error that keeps the warnings") {
  const TempFolder folder;
  const std::string none = "a.obj: error: mesh without triangles; give it at least one face with an area\n";
  CHECK(error_of(folder.write("a.obj", "")) == none);
  CHECK(error_of(folder.write("a.obj", triangle)) == none);
  CHECK(error_of(folder.write("a.obj", triangle + "f 1 1 2\n")) ==
        "a.obj:4:1: warning: faces skipped: 1 without area or whose edges cross (this is the first)\n" + none);
}

TEST_CASE("UTF-16 is refused with the remedy") {
  const TempFolder folder;
  using namespace std::string_literals;
  for (const std::string& text : {"\xFF\xFEv\0 \0"s, "\xFE\xFF\0v\0 "s, "v\0 \0"s, "\0v\0 "s}) {
    CHECK(
        error_of(folder.write("a.obj", text)) ==
        "a.obj:1:1: error: the text is UTF-16; convert it to UTF-8, for example with iconv -f UTF-16 -t UTF-8 a.obj\n");
  }
}

TEST_CASE("many errors are listed up to a limit and counted beyond") {
  const TempFolder folder;
  std::string text = triangle;
  for (int i = 0; i < 50; ++i) text += "f 1 2 7\n";
  const std::string errors = error_of(folder.write("a.obj", text));
  CHECK(errors.find("a.obj:23:7: error: ") != std::string::npos);
  CHECK(errors.find("a.obj:24:7: error: ") == std::string::npos);
  CHECK(errors.ends_with("a.obj: error: 30 more errors are not listed\n"));
}

TEST_CASE("files that cannot be read") {
  const TempFolder folder;
  CHECK(error_of(folder.path() + "/none.obj") ==
        "none.obj: error: cannot be read: there is no such file; is the path right?\n");
  std::filesystem::create_directory(folder.path() + "/folder.obj");
  CHECK(error_of(folder.path() + "/folder.obj") ==
        "folder.obj: error: cannot be read: it is a folder; name a file in it\n");
  CHECK(error_of(folder.write("a.stl", "")) ==
        "a.stl: error: extension \".stl\" is no mesh format that is read; use .obj, .ply or .serialized\n");
}

TEST_CASE("what the file says is shown cut and without control characters") {
  const TempFolder folder;
  const MeshFile file = read_mesh(folder.write("a.obj", triangle + "f 1 2 3\n\x1b[31m" + std::string(100, 'y') + "\n"));
  CHECK(test::text_of(file.warnings) ==
        "a.obj:5:1: warning: lines ignored: 1 with an unknown keyword; the first is \"?[31m" + std::string(35, 'y') +
            "...\"\n");
}

}  // namespace
}  // namespace strahl
