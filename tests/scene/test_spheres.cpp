// SPDX-License-Identifier: MIT
// <shape type="spheres">: spheres of a PLY file, text and binary, in place and order; what is wrong is named. 1 s.
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "scene/loader.h"

namespace strahl::test {
namespace {

struct Folder {
  std::filesystem::path path = std::filesystem::temp_directory_path() / "strahl-test-spheres";
  Folder() { std::filesystem::create_directories(path); }
  ~Folder() { std::filesystem::remove_all(path); }
  void file(const std::string& name, const std::string& text) const {
    std::ofstream(path / name, std::ios::binary) << text;
  }
};

const std::string properties = "property float x\nproperty float y\nproperty float z\nproperty float radius\n";

std::string ply(const std::string& header, const std::string& data, const std::string& format = "ascii") {
  return "ply\nformat " + format + " 1.0\n" + header + "end_header\n" + data;
}

Scene load(const std::string& file, const std::string& transform = "") {
  const Folder folder;
  folder.file("cloud.ply", file);
  folder.file("scene.xml",
              "<scene version=\"3.0.0\"><sensor type=\"perspective\"/>"
              "<bsdf type=\"diffuse\" id=\"red\"><rgb name=\"reflectance\" value=\"1, 0, 0\"/></bsdf>"
              "<shape type=\"sphere\"/><shape type=\"spheres\"><string name=\"filename\" value=\"cloud.ply\"/>"
              "<ref id=\"red\"/><boolean name=\"flip_normals\" value=\"true\"/>" +
                  transform + "</shape><shape type=\"rectangle\"/></scene>");
  return load_scene((folder.path / "scene.xml").string(), {{}, true, {}}).scene;
}

std::string fault(const std::string& file, const std::string& transform = "") {
  try {
    static_cast<void>(load(file, transform));
  } catch (const SceneError& error) {
    return error.what();
  }
  return "";
}

const std::string two = ply("element vertex 2\n" + properties, "1 2 3 0.5\n-4 5 6 2\n");

const std::vector<SphereCloud::Ball>& spheres_of(const Scene& scene) {
  return std::get<SphereCloud>(scene.shapes.at(1).geometry).spheres;
}

TEST_CASE("as many primitives as vertices, in order, alike but for their place") {
  const Scene scene = load(two);
  REQUIRE(scene.shapes.size() == 3);
  REQUIRE(primitive_count(scene.shapes[1]) == 2);
  CHECK(spheres_of(scene)[0].center == Vec3{1, 2, 3});
  CHECK(spheres_of(scene)[0].radius == 0.5);
  CHECK(spheres_of(scene)[1].center == Vec3{-4, 5, 6});
  CHECK(spheres_of(scene)[1].radius == 2);
  CHECK(scene.shapes[1].material == 1);
  CHECK(scene.shapes[1].flip_normals);
  CHECK(std::holds_alternative<Rectangle>(scene.shapes[2].geometry));
}

TEST_CASE("to_world places and scales all of them") {
  const Scene scene = load(two, "<transform name=\"to_world\"><scale value=\"2\"/><translate x=\"1\"/></transform>");
  CHECK(spheres_of(scene).at(1).center == Vec3{-7, 10, 12});
  CHECK(spheres_of(scene).at(1).radius == 4);
  CHECK(scene.shapes[1].flip_normals);
  // Mirrored ones face the other way, as a sphere does.
  CHECK_FALSE(load(two, "<transform name=\"to_world\"><scale x=\"-1\"/></transform>").shapes[1].flip_normals);
  CHECK_THAT(fault(two, "<transform name=\"to_world\"><scale x=\"2\"/></transform>"),
             Catch::Contains("scaled uniformly only"));
}

TEST_CASE("binary, other elements and properties, any order") {
  const float values[] = {0.5F, 9, 1, 2, 3};
  const std::string bytes(reinterpret_cast<const char*>(values), sizeof values);
  const Scene scene =
      load(ply("element nothing 9000000000000000000\nelement note 1\nproperty list uchar uchar text\n"
               "element vertex 1\nproperty float radius\nproperty float mass\n"
               "property float x\nproperty float y\nproperty float z\n",
               std::string("\2ab") + bytes, "binary_little_endian"));
  CHECK(spheres_of(scene).at(0).center == Vec3{1, 2, 3});
  CHECK(spheres_of(scene).at(0).radius == 0.5);
}

TEST_CASE("what is wrong is named, with its line") {
  CHECK_THAT(fault(ply("element vertex 1\n" + properties, "1 2 3 -1\n")), Catch::Contains("cloud.ply:9:1"));
  CHECK_THAT(fault(ply("element vertex 1\n" + properties, "1 nan 3 1\n")), Catch::Contains("finite"));
  CHECK_THAT(fault(ply("element vertex 1\nproperty float x\n", "1\n")), Catch::Contains("no property y"));
  CHECK_THAT(fault(ply("element vertex 0\n" + properties, "")), Catch::Contains("no spheres"));
  CHECK_THAT(fault(ply("element face 0\n", "")), Catch::Contains("no element vertex"));
  CHECK_THAT(fault(ply("element vertex 2\n" + properties, "1 2 3 1\n")), Catch::Contains("can hold at most 1"));
}

}  // namespace
}  // namespace strahl::test
