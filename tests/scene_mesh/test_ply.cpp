// SPDX-License-Identifier: MIT
// PLY files that must load: text and both byte orders, properties and elements in any order, names and types.
#include <cstdint>

#include "scene_mesh/ply_bytes.h"
#include "scene_mesh/temp_folder.h"

namespace strahl {
namespace {

using test::bytes;
using test::TempFolder;
using test::text_of;
using Triangles = std::vector<std::array<int, 3>>;

const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
const std::string square_header = "ply\nformat ascii 1.0\nelement vertex 4\n" + xyz +
                                  "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
const std::string square_data = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n";

void check_square(const MeshFile& file) {
  CHECK(file.mesh.positions == std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
  CHECK(file.mesh.triangles == Triangles{{0, 1, 2}, {0, 2, 3}});
  CHECK(file.mesh.part_of_triangle.empty());
  CHECK(text_of(file.warnings).empty());
}

TEST_CASE("text with every kind of line end") {
  const TempFolder folder;
  const std::string plain = square_header + square_data;
  std::string crlf, cr;
  for (char c : plain) {
    crlf += c == '\n' ? "\r\n" : std::string(1, c);
    cr += c == '\n' ? '\r' : c;
  }
  for (const std::string& text : {plain, crlf, cr, plain.substr(0, plain.size() - 1), plain + "\n \n"}) {
    check_square(read_mesh(folder.write("a.ply", text)));
  }
}

TEST_CASE("text is read in double where it is declared as float") {
  const TempFolder folder;
  const MeshFile file =
      read_mesh(folder.write("a.ply", square_header + "0.1 .5 +1e-3\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n"));
  CHECK(file.mesh.positions[0] == Vec3{0.1, 0.5, 1e-3});
}

TEST_CASE("further properties are attributes by Mitsuba's names") {
  const TempFolder folder;
  const std::string header =
      "ply\nformat ascii 1.0\nelement vertex 4\n" + xyz +
      "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty float nx\nproperty float ny\nproperty "
      "float nz\nproperty float heat_0\nproperty double flow_x\nproperty double flow_y\nproperty double "
      "flow_z\nproperty "
      "float tint_r\nproperty float tint_g\nproperty float tint_b\nproperty float odd_1\nproperty float "
      "odd_2\nproperty "
      "float quality\nelement face 2\nproperty float g\nproperty list uchar int vertex_indices\nproperty float "
      "b\nproperty float r\nproperty ushort mark_0\nend_header\n";
  // The second vertex has no normal, so that it is split between the two faces.
  const std::string data =
      "0 0 0 255 0 51 0 0 1 5 1 2 3 7 8 9 0 0 0\n1 0 0 0 255 0 0 0 0 6 4 5 6 1 1 1 0 0 0\n"
      "1 1 0.5 0 0 255 0 0 1 7 0 0 0 2 2 2 0 0 0\n0 1 0 1 2 3 0 0 1 8 9 9 9 3 3 3 0 0 0\n"
      "0.2 3 0 1 2 0.3 0.1 17\n0.5 3 1 3 2 0.6 0.4 18\n";
  const Mesh mesh = read_mesh(folder.write("a.ply", header + data)).mesh;
  const auto values = [&](const std::string& name) {
    for (const MeshAttribute& attribute : mesh.attributes)
      if (attribute.name == name) return attribute.values;
    return std::vector<Rgb>{};
  };
  CHECK(mesh.attributes.size() == 6);
  REQUIRE(mesh.positions.size() == 5);
  CHECK(mesh.positions[4] == mesh.positions[1]);
  CHECK(values("vertex_color") ==
        std::vector<Rgb>{{1, 0, 0.2}, {0, 1, 0}, {0, 0, 1}, {1 / 255., 2 / 255., 3 / 255.}, {0, 1, 0}});
  CHECK(values("vertex_heat") == std::vector<Rgb>{{5, 5, 5}, {6, 6, 6}, {7, 7, 7}, {8, 8, 8}, {6, 6, 6}});
  CHECK(values("vertex_flow")[0] == Rgb{1, 2, 3});
  CHECK(values("vertex_tint_color")[3] == Rgb{3, 3, 3});
  CHECK(values("face_color") == std::vector<Rgb>{{0.1, 0.2, 0.3}, {0.4, 0.5, 0.6}});
  CHECK(values("face_mark") == std::vector<Rgb>{{17, 17, 17}, {18, 18, 18}});
}

TEST_CASE("an attribute's components go by their letters, whatever their order in the header") {
  const TempFolder folder;
  const std::string header =
      "ply\nformat ascii 1.0\nelement vertex 3\n" + xyz +
      "property float tint_b\nproperty float tint_g\nproperty float flow_z\nproperty float "
      "tint_r\nproperty float flow_x\nproperty float flow_y\nproperty float part_2\nproperty float "
      "part_0\nproperty float part_1\nelement face 1\nproperty list uchar int "
      "vertex_indices\nend_header\n";
  const std::string numbers = " 3 2 6 1 4 5 9 7 8\n";
  const Mesh mesh =
      read_mesh(folder.write("a.ply", header + "0 0 0" + numbers + "1 0 0" + numbers + "0 1 0" + numbers + "3 0 1 2\n"))
          .mesh;
  REQUIRE(mesh.attributes.size() == 3);
  CHECK(mesh.attributes[0].name == "vertex_tint_color");
  CHECK(mesh.attributes[0].values[0] == Rgb{1, 2, 3});
  CHECK(mesh.attributes[1].name == "vertex_flow");
  CHECK(mesh.attributes[1].values[0] == Rgb{4, 5, 6});
  CHECK(mesh.attributes[2].name == "vertex_part");
  CHECK(mesh.attributes[2].values[0] == Rgb{7, 8, 9});
}

TEST_CASE("a second colour of the vertices is left out with a warning") {
  const TempFolder folder;
  const std::string header = "ply\nformat ascii 1.0\nelement vertex 3\n" + xyz +
                             "property float color_0\nproperty float r\nproperty float g\nproperty float b\nelement "
                             "face 1\nproperty list uchar int vertex_indices\nend_header\n";
  const MeshFile file =
      read_mesh(folder.write("a.ply", header + "0 0 0 7 1 2 3\n1 0 0 7 1 2 3\n0 1 0 7 1 2 3\n3 0 1 2\n"));
  REQUIRE(file.mesh.attributes.size() == 1);
  CHECK(file.mesh.attributes[0].name == "vertex_color");
  CHECK(file.mesh.attributes[0].values[0] == Rgb{1, 2, 3});
  REQUIRE(file.warnings.size() == 1);
  CHECK(file.warnings[0].message.find("the property color_0 is left out") != std::string::npos);
}

TEST_CASE("a header of very many attributes is read in one pass") {
  const TempFolder folder;
  std::string header = "ply\nformat ascii 1.0\nelement vertex 3\n" + xyz, numbers;
  for (int i = 0; i < 200000; ++i) {
    header += "property float p" + std::to_string(i) + "_0\n";
    numbers += " 1";
  }
  header += "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
  const std::string body = "0 0 0" + numbers + "\n1 0 0" + numbers + "\n0 1 0" + numbers + "\n3 0 1 2\n";
  CHECK(read_mesh(folder.write("a.ply", header + body)).mesh.attributes.size() == 200000);
}

TEST_CASE("a polygon's attributes are those of all its triangles") {
  const TempFolder folder;
  const std::string header =
      "ply\nformat ascii 1.0\nelement vertex 4\n" + xyz +
      "element face 3\nproperty list uchar int vertex_indices\nproperty float heat_0\nend_header\n";
  // The second face has no area.
  const MeshFile file =
      read_mesh(folder.write("a.ply", header + "0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3 7\n3 0 0 1 8\n3 0 1 2 9\n"));
  CHECK(file.mesh.attributes.at(0).values == std::vector<Rgb>{{7, 7, 7}, {7, 7, 7}, {9, 9, 9}});
}

TEST_CASE("binary of both byte orders, doubles, header with each line end") {
  const TempFolder folder;
  for (bool big : {false, true}) {
    for (const std::string end : {"\n", "\r\n", "\r"}) {
      std::string data;
      for (double v : {0.1, 0.2, 0.3, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0}) data += bytes(v, big);
      data += bytes<std::uint16_t>(3, big);
      for (std::uint32_t i : {0u, 1u, 2u}) data += bytes(i, big);
      std::string header = std::string("ply\nformat binary_") + (big ? "big" : "little") +
                           "_endian 1.0\nelement vertex 3\nproperty double x\nproperty float64 y\nproperty double "
                           "z\nelement face 1\nproperty list ushort uint vertex_index\nend_header\n";
      for (std::size_t i = 0; (i = header.find('\n', i)) != std::string::npos; i += end.size())
        header.replace(i, 1, end);
      const MeshFile file = read_mesh(folder.write("a.ply", header + data));
      CHECK(file.mesh.positions == std::vector<Vec3>{{0.1, 0.2, 0.3}, {1, 0, 0}, {0, 1, 0}});
      CHECK(file.mesh.triangles == Triangles{{0, 1, 2}});
      CHECK(text_of(file.warnings).empty());
    }
  }
}

TEST_CASE("other properties and elements are passed over, lists too, in any order") {
  const TempFolder folder;
  const std::string body =
      "comment ends in a backslash \\\nobj_info x\nelement camera 2\nproperty list uchar float what\nproperty double "
      "q\nelement face 1\nproperty uchar red\nproperty list uint8 float32 texcoord\nproperty list int8 int16 "
      "vertex_indices\nproperty short after\nelement empty 5\nelement vertex 4\nproperty int z\nproperty list uchar "
      "uchar "
      "l\nproperty short y\nproperty char x\nproperty uchar alpha\nend_header\n";
  check_square(read_mesh(folder.write(
      "text.ply",
      "ply\nformat ascii 1.0\n" + body +
          "2 0.5 0.5 1\n0 1\n7 2 0.1 0.2 4 0 1 2 3 9\n0 0 0 0 1\n0 1 5 0 1 1\n0 2 5 5 1 1 1\n0 0 1 0 1\n")));
  for (bool big : {false, true}) {
    std::string data = bytes<std::uint8_t>(2, big) + bytes(0.5f, big) + bytes(0.5f, big) + bytes(1.0, big) +
                       bytes<std::uint8_t>(0, big) + bytes(1.0, big);
    data += bytes<std::uint8_t>(7, big) + bytes<std::uint8_t>(1, big) + bytes(0.1f, big) + bytes<std::int8_t>(4, big);
    for (int i : {0, 1, 2, 3, -9}) data += bytes(static_cast<std::int16_t>(i), big);
    const int corners[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    for (const auto& [x, y] : corners) {
      data += bytes<std::int32_t>(0, big) + bytes<std::uint8_t>(1, big) + "l" +
              bytes(static_cast<std::int16_t>(y), big) + bytes(static_cast<std::int8_t>(x), big) + "a";
    }
    const std::string format = big ? "binary_big_endian" : "binary_little_endian";
    check_square(read_mesh(folder.write("binary.ply", "ply\nformat " + format + " 1.0\n" + body + data)));
  }
}

TEST_CASE("normals become unit vectors; texture coordinates have several names") {
  const TempFolder folder;
  for (const auto& [u, v] : {std::pair("u", "v"), std::pair("s", "t"), std::pair("texture_u", "texture_v")}) {
    const std::string header = "ply\nformat ascii 1.0\nelement vertex 3\n" + xyz +
                               "property float nx\nproperty float ny\nproperty float nz\nproperty float " + u +
                               "\nproperty float " + v +
                               "\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";
    const MeshFile file =
        read_mesh(folder.write("a.ply", header + "0 0 0 0 3 0 .1 .2\n1 0 0 0 0 0 .3 .4\n0 1 0 0 0 2 .5 .6\n3 0 1 2\n"));
    CHECK(file.mesh.normals == std::vector<Vec3>{{0, 1, 0}, {0, 0, 1}, {0, 0, 1}});
    CHECK(file.mesh.uvs == std::vector<Vec2>{{.1, .2}, {.3, .4}, {.5, .6}});
    CHECK(text_of(file.warnings) == "a.ply: warning: 1 vertices have a normal of length 0; their faces' stand in\n");
  }
}

TEST_CASE("texture coordinates are the first whole pair of names, whatever their order in the file") {
  const TempFolder folder;
  const auto uvs = [&](const std::vector<std::string>& names) {
    std::string header = "ply\nformat ascii 1.0\nelement vertex 3\n" + xyz, numbers;
    for (std::size_t i = 0; i < names.size(); ++i) {
      header += "property float " + names[i] + "\n";
      numbers += " " + std::to_string(i + 1);
    }
    const std::string file = header + "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0" +
                             numbers + "\n1 0 0" + numbers + "\n0 1 0" + numbers + "\n3 0 1 2\n";
    const MeshFile read = read_mesh(folder.write("a.ply", file));
    CHECK(text_of(read.warnings).empty());
    return read.mesh.uvs.empty() ? std::vector<Vec2>{} : std::vector<Vec2>{read.mesh.uvs.front()};
  };
  CHECK(uvs({"t", "u", "v"}) == std::vector<Vec2>{{2, 3}});
  CHECK(uvs({"s", "t", "v", "u"}) == std::vector<Vec2>{{4, 3}});
  CHECK(uvs({"s", "t", "texture_u", "texture_v"}) == std::vector<Vec2>{{3, 4}});
  CHECK(uvs({"texture_u", "s", "t"}) == std::vector<Vec2>{{2, 3}});
  CHECK(uvs({"texture_t", "texture_s"}) == std::vector<Vec2>{{2, 1}});
  CHECK(uvs({"u", "t"}).empty());
}

TEST_CASE("triangle strips turn every other triangle round and begin anew at -1") {
  const TempFolder folder;
  const auto triangles = [&](const std::string& strips) {
    const std::string header = "ply\nformat ascii 1.0\nelement vertex 5\n" + xyz +
                               "element tristrips 1\nproperty list int int vertex_indices\nend_header\n";
    const MeshFile file = read_mesh(folder.write("a.ply", header + "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 1\n" + strips));
    CHECK(text_of(file.warnings).empty());
    return file.mesh.triangles;
  };
  CHECK(triangles("5 0 1 2 3 4\n") == Triangles{{0, 1, 2}, {2, 1, 3}, {2, 3, 4}});
  CHECK(triangles("7 0 1 2 -1 1 3 2\n") == Triangles{{0, 1, 2}, {1, 3, 2}});
  // 2 2 leads on: the triangle after it is the fifth.
  CHECK(triangles("6 0 1 2 2 3 4\n") == Triangles{{0, 1, 2}, {3, 2, 4}});
}

TEST_CASE("unused vertices are left out, bad ones with a warning; skipped faces are counted") {
  const TempFolder folder;
  const MeshFile file = read_mesh(folder.write(
      "a.ply",
      "ply\nformat ascii 1.0\nelement vertex 5\n" + xyz +
          "element face 4\nproperty list uchar int vertex_indices\nend_header\n9 9 9\nnan 0 0\n0 0 0\n1 0 0\n0 1 "
          "0\n2 0 2\n3 2 3 4\n0\n3 2 3 3\n"));
  CHECK(file.mesh.positions == std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  CHECK(file.skipped_faces == 3);
  CHECK(
      text_of(file.warnings) ==
      "a.ply:11:1: warning: vertex not made of finite numbers: 1 that no face uses (this is the first)\n"
      "a.ply:15:1: warning: faces skipped: 3 with fewer than 3 corners, without area or whose edges cross (this is the "
      "first)\n");
}

TEST_CASE("elements of a text may wrap over lines, as in Mitsuba") {
  const TempFolder folder;
  check_square(read_mesh(folder.write("a.ply", square_header + "0 0 0\n1\n0 0\n1 1\n\n0\n0 1 0\n4\n0 1\n 2 3\n")));
}

TEST_CASE("what is too much is a warning") {
  const TempFolder folder;
  const MeshFile text =
      read_mesh(folder.write("a.ply", "ply\nformat ascii 1.0\nmade by me\n" + square_header.substr(21) +
                                          "0 0 0 7\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3 4\nrest\n"));
  CHECK(text_of(text.warnings) ==
        "a.ply:3:1: warning: header lines ignored: 1 with an unknown keyword\n"
        "a.ply:11:7: warning: lines with more values than the header names: 2\n"
        "a.ply:16:1: warning: text after the last element is ignored\n");
  std::string header = square_header;
  header.replace(header.find("ascii"), 5, "binary_little_endian");
  std::string data;
  for (float v : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 1.f, 1.f, 0.f, 0.f, 1.f, 0.f}) data += bytes(v, false);
  data += bytes<std::uint8_t>(4, false);
  for (int i : {0, 1, 2, 3}) data += bytes(i, false);
  const std::size_t end = header.size() + data.size();
  const MeshFile binary = read_mesh(folder.write("a.ply", header + data + "rest"));
  CHECK(text_of(binary.warnings) ==
        "a.ply: warning: byte " + std::to_string(end) + ": 4 bytes after the last element are ignored\n");
}

}  // namespace
}  // namespace strahl
