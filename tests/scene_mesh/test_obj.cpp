// SPDX-License-Identifier: MIT
// OBJ files that must load: every spelling of numbers, lines and faces; vertex splitting; stand-in normals.
#include "scene_mesh/temp_folder.h"

namespace strahl {
namespace {

using test::TempFolder;
using test::text_of;
using Triangles = std::vector<std::array<int, 3>>;

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST_CASE("positions keep every bit of a double") {
  const TempFolder folder;
  const MeshFile file =
      read_mesh(folder.write("a.obj", "v 0.1 1234567.89012345678 -3e-7\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
  CHECK(file.mesh.positions[0] == Vec3{0.1, 1234567.89012345678, -3e-7});
  CHECK(file.mesh.triangles == Triangles{{0, 1, 2}});
  CHECK(file.mesh.normals.empty());
  CHECK(file.mesh.uvs.empty());
  CHECK(file.materials.empty());
  CHECK(file.mesh.part_of_triangle.empty());
  CHECK(file.warnings.empty());
}

TEST_CASE("numbers in every spelling") {
  const TempFolder folder;
  const MeshFile file =
      read_mesh(folder.write("a.obj", "v .5 +1 1e+05\nv -.5e-1 2. 0e00005\nv +.25E1 1e-400 -0\nf 1 2 3\n"));
  CHECK(file.mesh.positions == std::vector<Vec3>{{0.5, 1, 1e5}, {-0.05, 2, 0}, {2.5, 0, 0}});
}

TEST_CASE("weights and vertex colours are not read") {
  const TempFolder folder;
  const MeshFile file = read_mesh(folder.write("a.obj", "v 0 0 0 0.5\nv 1 0 0 1 0 0\nv 0 1 0 what ever\nf 1 2 3\n"));
  CHECK(file.mesh.positions == std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
}

TEST_CASE("every kind of line end, blank and comment gives the same mesh") {
  const TempFolder folder;
  const std::string plain = square + "f 1 2 3 4\n";
  std::string crlf, cr;
  for (char c : plain) {
    crlf += c == '\n' ? "\r\n" : std::string(1, c);
    cr += c == '\n' ? '\r' : c;
  }
  const std::string odd =
      "\xEF\xBB\xBF# comment with a backslash \\\n\t v  0\t0 0 # here\n\n   \nv 1 0 0   \nv 1 \\\n 1 \\\r\n 0\nv 0 1 "
      "0\nf 1 "
      "2 3 \\\n4";
  for (const std::string& text : {plain, crlf, cr, odd, plain.substr(0, plain.size() - 1)}) {
    const MeshFile file = read_mesh(folder.write("a.obj", text));
    CHECK(file.mesh.positions == std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
    CHECK(file.mesh.triangles == Triangles{{0, 1, 2}, {0, 2, 3}});
    CHECK(file.warnings.empty());
  }
}

TEST_CASE("the extension may be in capitals") {
  const TempFolder folder;
  CHECK(read_mesh(folder.write("A.OBJ", square + "f 1 2 3\n")).mesh.triangles.size() == 1);
}

TEST_CASE("faces in every spelling, with negative indices and vertices that come later") {
  const TempFolder folder;
  for (const char* face : {"f 1 2 3", "f -3 -2 -1", "f 1/1 2/1 3/1", "f 1//1 2//1 3//1", "f 1/1/1 2/1/1 3/1/1",
                           "f -3/-1/-1 -2/-1/-1 -1/-1/-1", "f 1/ 2/ 3/", "f 1// 2// 3//", "f +1 2 3"}) {
    const MeshFile file =
        read_mesh(folder.write("a.obj", "vt 0.25 0.75\nvn 0 0 2\nv 0 0 0\nv 1 0 0\nv 0 1 0\n" + std::string(face)));
    const std::string_view text = face;
    CHECK(file.mesh.triangles == Triangles{{0, 1, 2}});
    const bool has_uv = text.find("/1") != std::string::npos ? text.find("//1") == std::string::npos
                                                             : text.find("/-1/") != std::string::npos;
    CHECK(file.mesh.uvs == (has_uv ? std::vector<Vec2>(3, {0.25, 0.75}) : std::vector<Vec2>{}));
    const bool has_normal = text.find("//1") != std::string::npos || text.find("1/1/1") != std::string::npos ||
                            text.find("/-1/-1") != std::string::npos;
    CHECK(file.mesh.normals == (has_normal ? std::vector<Vec3>(3, {0, 0, 1}) : std::vector<Vec3>{}));
  }
  CHECK(read_mesh(folder.write("b.obj", "f 1 2 3\n" + square)).mesh.triangles.size() == 1);
}

TEST_CASE("negative indices count from the vertices read so far") {
  const TempFolder folder;
  const MeshFile file = read_mesh(folder.write("a.obj", square + "f -4 -3 -2\nv 5 5 5\nf -1 -2 -3\n"));
  CHECK(file.mesh.positions[static_cast<std::size_t>(file.mesh.triangles[1][0])] == Vec3{5, 5, 5});
  CHECK(file.mesh.positions[static_cast<std::size_t>(file.mesh.triangles[1][1])] == Vec3{0, 1, 0});
}

TEST_CASE("a vertex is split where normal or texture coordinate differ, and shared where they do not") {
  const TempFolder folder;
  const std::string two = square + "vt 0 0\nvt 1 1\nvn 0 0 1\nvn 0 1 0\n";
  CHECK(read_mesh(folder.write("a.obj", two + "f 1/1/1 2/1/1 3/1/1\nf 1/1/1 3/1/1 4/1/1")).mesh.positions.size() == 4);
  CHECK(read_mesh(folder.write("a.obj", two + "f 1/1/1 2/1/1 3/1/1\nf 1/2/1 3/1/1 4/1/1")).mesh.positions.size() == 5);
  CHECK(read_mesh(folder.write("a.obj", two + "f 1/1/1 2/1/1 3/1/1\nf 1/1/2 3/1/2 4/1/1")).mesh.positions.size() == 6);
}

TEST_CASE("a vertex that a hundred faces split is shared as well as any other") {
  const TempFolder folder;
  std::string text = "v 0 0 1\n";
  for (int i = 0; i < 100; ++i) text += "v " + std::to_string(i) + " 1 0\nvn 0 1 " + std::to_string(i) + "\n";
  for (int round = 0; round < 2; ++round) {
    for (int i = 1; i < 100; ++i) {
      const std::string n = "//" + std::to_string(i) + ' ';
      text += "f 1" + n + std::to_string(i + 1) + n + std::to_string(i + 2) + n + '\n';
    }
  }
  const Mesh mesh = read_mesh(folder.write("a.obj", text)).mesh;
  CHECK(mesh.positions.size() == 3 * 99);
  REQUIRE(mesh.triangles.size() == 2 * 99);
  for (std::size_t i = 0; i < 99; ++i) CHECK(mesh.triangles[i] == mesh.triangles[i + 99]);
}

TEST_CASE("what no triangle uses is left out") {
  const TempFolder folder;
  const MeshFile file = read_mesh(folder.write("a.obj", "v 9 9 9\n" + square + "v nan 0 0\nf 2 3 4\n"));
  CHECK(file.mesh.positions == std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}});
  CHECK(text_of(file.warnings) ==
        "a.obj:6:3: warning: vertex not made of finite numbers: 1 that no face uses (this is the first)\n");
}

TEST_CASE("missing normals and texture coordinates are filled in") {
  const TempFolder folder;
  // The first triangle has no normals, the second has one of length 0; they lie in different planes.
  const MeshFile file = read_mesh(folder.write(
      "a.obj",
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvt 1 1\nvn 3 0 0\nvn 0 0 0\nf 1 2 3\nf 1 4/1 2\nf 1//1 3//2 4//1\n"));
  REQUIRE(file.mesh.triangles.size() == 3);
  const auto normal = [&](std::size_t t, std::size_t corner) {
    return file.mesh.normals[static_cast<std::size_t>(file.mesh.triangles[t][corner])];
  };
  for (std::size_t corner = 0; corner < 3; ++corner) {
    CHECK(normal(0, corner) == Vec3{0, 0, 1});
    CHECK(normal(1, corner) == Vec3{0, 1, 0});
    CHECK(normal(2, corner) == Vec3{1, 0, 0});
  }
  CHECK(file.mesh.uvs.size() == file.mesh.positions.size());
  CHECK(file.mesh.uvs[static_cast<std::size_t>(file.mesh.triangles[1][1])] == Vec2{1, 1});
  CHECK(file.mesh.uvs[static_cast<std::size_t>(file.mesh.triangles[0][1])] == Vec2{0, 0});
  CHECK(file.warnings.size() == 2);
}

TEST_CASE("concave polygons are cut inside, not fanned across") {
  const TempFolder folder;
  const MeshFile file = read_mesh(folder.write("a.obj", "v 4 0 0\nv 1 1 0\nv 0 4 0\nv 0 0 0\nf 1 2 3 4\n"));
  double area = 0;
  for (const auto& t : file.mesh.triangles) {
    const auto at = [&](std::size_t i) { return file.mesh.positions[static_cast<std::size_t>(t[i])]; };
    area += length(cross(at(1) - at(0), at(2) - at(0))) / 2;
  }
  CHECK(area == 4);
}

TEST_CASE("skipped faces are counted, with the first one's place") {
  const TempFolder folder;
  const MeshFile file = read_mesh(
      folder.write("a.obj", square + "f 1 2\nf 1 2 3\nf\nf 1 x 2\nf 1/1/1/1 2 3\nf 1 1 2\n  f 1 2 2\nf 1. 2 3\n"));
  CHECK(file.mesh.triangles.size() == 1);
  CHECK(file.skipped_faces == 7);
  CHECK(text_of(file.warnings) ==
        "a.obj:5:1: warning: faces skipped: 5 that cannot be read or have fewer than 3 corners (this is the first)\n"
        "a.obj:10:1: warning: faces skipped: 2 without area or whose edges cross (this is the first)\n");
}

TEST_CASE("lines, points and unknown keywords: one warning each") {
  const TempFolder folder;
  const MeshFile file =
      read_mesh(folder.write("a.obj", square + "o x\ng\ns 1\nl 1 2\np 1\nl 2 3\nf 1 2 3\nvw 1\ncurv 2\nvw 2\n"));
  CHECK(text_of(file.warnings) ==
        "a.obj:8:1: warning: lines and points are not rendered: 3 (this is the first)\n"
        "a.obj:12:1: warning: lines ignored: 3 with an unknown keyword; the first is \"vw\"\n");
}

}  // namespace
}  // namespace strahl
