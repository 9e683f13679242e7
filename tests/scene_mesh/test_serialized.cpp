// SPDX-License-Identifier: MIT
// Serialized meshes that must load: both versions and precisions, every attribute, one mesh of several.
#include "scene/loader.h"
#include "scene_mesh/serialized_bytes.h"
#include "scene_mesh/temp_folder.h"

namespace strahl {
namespace {

using test::serialized_file;
using test::SerializedMesh;
using test::TempFolder;
using test::text_of;
using Triangles = std::vector<std::array<int, 3>>;

/// Its corners moved along x by `x`.
SerializedMesh triangle_at(double x) {
  SerializedMesh mesh;
  for (std::size_t i = 0; i < 9; i += 3) mesh.numbers[i] += x;
  return mesh;
}

TEST_CASE("positions and triangles in both versions and precisions") {
  const TempFolder folder;
  for (const int version : {3, 4}) {
    for (const std::uint32_t flags : {0u, 0x1000u, 0x2000u}) {
      SerializedMesh mesh;
      mesh.flags = flags;
      mesh.vertices = 4;
      mesh.triangles = 2;
      mesh.numbers = {0, 0, 0, 1, 0, 0, 1, 1, 0.1, 0, 1, 0};
      mesh.indices = {0, 1, 2, 0, 2, 3};
      const MeshFile file = read_mesh(folder.write("a.serialized", serialized_file({mesh}, version)));
      const double tenth = flags == 0x2000 ? 0.1 : static_cast<double>(0.1f);
      CHECK(file.mesh.positions == std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, tenth}, {0, 1, 0}});
      CHECK(file.mesh.triangles == Triangles{{0, 1, 2}, {0, 2, 3}});
      CHECK(file.mesh.normals.empty());
      CHECK(file.mesh.uvs.empty());
      CHECK(file.mesh.part_of_triangle.empty());
      CHECK(text_of(file.warnings).empty());
    }
  }
}

TEST_CASE("normals become unit vectors, texture coordinates and colours are kept") {
  const TempFolder folder;
  SerializedMesh mesh;
  mesh.flags = 0x200B;
  mesh.numbers.insert(mesh.numbers.end(), {0, 0, 2, 0, 3, 0, 4, 0, 0});
  mesh.numbers.insert(mesh.numbers.end(), {.1, .2, .3, .4, .5, .6});
  mesh.numbers.insert(mesh.numbers.end(), {1, 0, 0, 0, 1, 0, 0, 0, 1});
  MeshFile file = read_mesh(folder.write("a.serialized", serialized_file({mesh})));
  CHECK(file.mesh.normals == std::vector<Vec3>{{0, 0, 1}, {0, 1, 0}, {1, 0, 0}});
  CHECK(file.mesh.uvs == std::vector<Vec2>{{.1, .2}, {.3, .4}, {.5, .6}});
  CHECK(file.mesh.triangles == Triangles{{0, 1, 2}});
  REQUIRE(file.mesh.attributes.size() == 1);
  CHECK(file.mesh.attributes[0].name == "vertex_color");
  CHECK(file.mesh.attributes[0].values == std::vector<Rgb>{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  mesh.flags |= 0x0010;
  const std::string flat = folder.write("a.serialized", serialized_file({mesh}));
  CHECK(read_mesh(flat).mesh.normals.size() == 3);  // As Mitsuba 3, which ignores the flag.
  file = read_serialized(flat, 0, {}, MeshNormals::as_file_says);
  CHECK(file.face_normals);
  CHECK(file.mesh.normals.empty());
  CHECK(file.mesh.uvs.size() == 3);
  CHECK(file.mesh.triangles == Triangles{{0, 1, 2}});
  CHECK(text_of(file.warnings).empty());
}

TEST_CASE("one mesh of several") {
  const TempFolder folder;
  for (const int version : {3, 4}) {
    const std::string path =
        folder.write("a.serialized", serialized_file({triangle_at(0), triangle_at(10), triangle_at(20)}, version));
    for (const int index : {0, 1, 2}) CHECK(read_serialized(path, index).mesh.positions[0] == Vec3{10.0 * index, 0, 0});
  }
}

TEST_CASE("the first mesh needs no list at the end of the file") {
  const TempFolder folder;
  const std::string bare = test::serialized_header(4) + test::zlib_stream(triangle_at(5).content(4));
  CHECK(read_mesh(folder.write("a.serialized", bare)).mesh.positions[0] == Vec3{5, 0, 0});
}

TEST_CASE("a large mesh goes through many blocks") {
  const TempFolder folder;
  SerializedMesh mesh;
  mesh.flags = 0x2000;
  mesh.vertices = 20000;
  mesh.numbers.clear();
  mesh.indices.clear();
  for (int i = 0; i < 20000; ++i) mesh.numbers.insert(mesh.numbers.end(), {0.5 * i, i % 2 * 1.0, 0});
  for (std::uint32_t i = 0; i + 2 < 20000; ++i) mesh.indices.insert(mesh.indices.end(), {i, i + 1, i + 2});
  mesh.triangles = mesh.indices.size() / 3;
  const Mesh read = read_mesh(folder.write("a.serialized", serialized_file({mesh}))).mesh;
  REQUIRE(read.positions.size() == 20000);
  REQUIRE(read.triangles.size() == 19998);
  for (int i = 0; i < 19998; ++i) {
    REQUIRE(read.triangles[static_cast<std::size_t>(i)] == std::array{i, i + 1, i + 2});
    REQUIRE(read.positions[static_cast<std::size_t>(i)].x == 0.5 * i);
  }
}

TEST_CASE("degenerate triangles are skipped and unused vertices left out") {
  const TempFolder folder;
  SerializedMesh mesh;
  mesh.vertices = 5;
  mesh.numbers = {9, 9, 9, 0, 0, 0, 1, 0, 0, 0, 1, 0, std::numeric_limits<double>::quiet_NaN(), 0, 0};
  mesh.triangles = 2;
  mesh.indices = {1, 2, 3, 1, 2, 2};
  mesh.surplus = "!";
  const MeshFile file = read_mesh(folder.write("a.serialized", serialized_file({mesh})));
  CHECK(file.mesh.positions == std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  CHECK(file.skipped_faces == 1);
  CHECK(text_of(file.warnings) ==
        "a.serialized: warning: byte 0: bytes after the last triangle of the mesh are ignored\n"
        "a.serialized: warning: byte 0: triangles without area skipped: 1\n"
        "a.serialized: warning: byte 0: vertex not made of finite numbers: 1 that no face uses (this is the first)\n");
}

TEST_CASE("a shape chooses its mesh, and what becomes of it") {
  const TempFolder folder;
  SerializedMesh mesh = triangle_at(3);
  mesh.flags = 0x1002;
  mesh.numbers.insert(mesh.numbers.end(), {0, 0.25, 1, 0, 0, 1});
  folder.write("a.serialized", serialized_file({triangle_at(0), mesh}));
  const auto loaded = [&](const std::string& inside) {
    return std::get<Mesh>(load_scene(folder.write("scene.xml",
                                                  "<scene version=\"3.0.0\"><sensor type=\"perspective\"/>"
                                                  "<shape type=\"serialized\"><string name=\"filename\" "
                                                  "value=\"a.serialized\"/>" +
                                                      inside + "</shape></scene>"))
                              .scene.shapes.at(0)
                              .geometry);
  };
  CHECK(loaded("").positions[0] == Vec3{0, 0, 0});
  const std::string second = "<integer name=\"shape_index\" value=\"1\"/>";
  CHECK(loaded(second + "<transform name=\"to_world\"><scale value=\"2\"/></transform>").positions[0] == Vec3{6, 0, 0});
  CHECK(loaded(second).uvs[0] == Vec2{0, 0.25});
  CHECK(loaded(second + "<boolean name=\"flip_tex_coords\" value=\"true\"/>").uvs[0] == Vec2{0, 0.75});
}

TEST_CASE("a bare file is a scene of its first mesh") {
  const TempFolder folder;
  const std::string path = folder.write("a.serialized", serialized_file({triangle_at(7), triangle_at(8)}));
  CHECK(std::get<Mesh>(load_scene(path).scene.shapes.at(0).geometry).positions[0] == Vec3{7, 0, 0});
}

}  // namespace
}  // namespace strahl
