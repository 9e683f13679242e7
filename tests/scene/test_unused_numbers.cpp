// SPDX-License-Identifier: MIT
// Numbers of mesh files that are not finite are faults where the scene uses them, and nothing elsewhere.
#include <catch2/catch.hpp>
#include <limits>

#include "scene/scene_text.h"
#include "scene_mesh/serialized_bytes.h"

using namespace strahl;
using namespace strahl::test;

namespace {

const char* const flat = "<boolean name=\"face_normals\" value=\"true\"/>";
const char* const creased = "<float name=\"max_smooth_angle\" value=\"30\"/>";

/// The problems of a shape with this file and these parameters.
std::vector<std::string> problems_of(const std::string& name, const std::string& content, const std::string& inside,
                                     const std::string& before = "") {
  const SceneFolder folder;
  folder.write(name, content);
  const std::string shape = "<shape type=\"" + name.substr(name.find('.') + 1) +
                            "\"><string name=\"filename\" value=\"" + name + "\"/>" + inside + "</shape>";
  try {
    return shortened(load_scene(folder.write("scene.xml", around(before + shape))).warnings);
  } catch (const SceneError& error) {
    return shortened(error.diagnostics());
  }
}

void check_normals(const std::string& name, const std::string& content, const std::string& noun) {
  INFO(name);
  const std::vector<std::string> found = problems_of(name, content, "");
  REQUIRE(found.size() == 1);
  CHECK_THAT(found[0], Catch::Contains("error: ") && Catch::Contains(noun + " is not made of finite numbers"));
  for (const char* unused : {flat, creased}) CHECK(problems_of(name, content, unused).empty());
}

}  // namespace

TEST_CASE("normals that are no numbers are none of the concern of a mesh without the file's normals") {
  check_normals("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nvn nan 0 1\nf 1//1 2//1 3//2\n", "normal 2");
  check_normals("a.ply",
                "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
                "property float nx\nproperty float ny\nproperty float nz\nelement face 1\nproperty list uchar int "
                "vertex_indices\nend_header\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 nan 0 1\n3 0 1 2\n",
                "vertex 3");
  SerializedMesh mesh;
  mesh.flags |= 0x0001;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  mesh.numbers.insert(mesh.numbers.end(), {0, 0, 1, 0, 0, 1, nan, 0, 1});
  check_normals("a.serialized", serialized_file({mesh}), "normal 3");
}

TEST_CASE("attributes that are no numbers are faults where a texture shows them") {
  const auto shown = [](const std::string& attribute) {
    return "<bsdf type=\"diffuse\" id=\"a\"><texture type=\"mesh_attribute\" name=\"reflectance\"><string "
           "name=\"name\" value=\"" +
           attribute + "\"/></texture></bsdf>";
  };
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
      "property float heat_0\nproperty float cold_0\nelement face 1\nproperty list uchar int vertex_indices\n"
      "property float wet_0\nend_header\n5 5 5 nan nan\n0 0 0 1 1\n1 0 0 1 1\n0 1 0 nan 1\n3 1 2 3 nan\n";
  CHECK(problems_of("a.ply", ply, "").empty());
  CHECK(problems_of("a.ply", ply, "<ref id=\"a\"/>", shown("vertex_cold")).empty());
  const std::vector<std::string> hot = problems_of("a.ply", ply, "<ref id=\"a\"/>", shown("vertex_heat"));
  REQUIRE(hot.size() == 1);
  CHECK_THAT(hot[0], Catch::Contains("error: \"vertex_heat\" is not made of finite numbers, and a texture shows it"));
  const std::vector<std::string> wet = problems_of("a.ply", ply, "<ref id=\"a\"/>", shown("face_wet"));
  REQUIRE(wet.size() == 1);
  CHECK_THAT(wet[0], Catch::Contains("error: \"face_wet\" is not made of finite numbers"));
  SerializedMesh mesh;
  mesh.flags |= 0x0008;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  mesh.numbers.insert(mesh.numbers.end(), {0, 0, 1, 0, nan, 1, 0, 0, 1});
  CHECK(problems_of("a.serialized", serialized_file({mesh}), "").empty());
  CHECK_THAT(problems_of("a.serialized", serialized_file({mesh}), "<ref id=\"a\"/>", shown("vertex_color")).at(0),
             Catch::Contains("error: ") && Catch::Contains("\"vertex_color\" is not made of finite numbers"));
}
