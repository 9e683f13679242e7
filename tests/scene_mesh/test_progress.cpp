// SPDX-License-Identifier: MIT
// How far a mesh file is read is told while it is read.
#include <stdexcept>

#include "scene/loader.h"
#include "scene_mesh/ply_bytes.h"
#include "scene_mesh/temp_folder.h"

namespace strahl {
namespace {

using test::bytes;
using test::TempFolder;

constexpr int triangles = 80000;

std::string obj() {
  std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  for (int i = 0; i < triangles; ++i) text += "# the same triangle over and over again\nf 1 2 3\n";
  return text;
}

std::string ply_header(const std::string& format) {
  return "ply\nformat " + format + " 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n" +
         "element face " + std::to_string(triangles) + "\nproperty list uint int vertex_indices\n" +
         "property double a\nproperty double b\nend_header\n";
}

std::string ply_text() {
  std::string text = ply_header("ascii") + "0 0 0\n1 0 0\n0 1 0\n";
  for (int i = 0; i < triangles; ++i) text += "3 0 1 2 0.123456789012345678 1234567890\n";
  return text;
}

std::string ply_binary() {
  std::string data = ply_header("binary_little_endian");
  for (const float x : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f}) data += bytes(x, false);
  std::string face = bytes<std::uint32_t>(3, false);
  for (const std::int32_t i : {0, 1, 2}) face += bytes(i, false);
  face += std::string(16, '\0');
  for (int i = 0; i < triangles; ++i) data += face;
  return data;
}

TEST_CASE("the share of a large file rises from little to nearly all") {
  const TempFolder folder;
  for (const auto& [name, text] :
       {std::pair("a.obj", obj()), std::pair("text.ply", ply_text()), std::pair("binary.ply", ply_binary())}) {
    INFO(name);
    std::vector<double> shares;
    const MeshFile file = read_mesh(folder.write(name, text), [&](double share) { shares.push_back(share); });
    CHECK(file.mesh.triangles.size() == triangles);
    REQUIRE(shares.size() >= 2);
    CHECK(std::ranges::is_sorted(shares));
    CHECK(shares.front() < 0.6);
    CHECK(shares.back() > 0.5);
    CHECK(shares.back() <= 1);
  }
}

TEST_CASE("a small file is not reported") {
  const TempFolder folder;
  bool reported = false;
  const std::string path = folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  static_cast<void>(read_mesh(path, [&](double) { reported = true; }));
  CHECK_FALSE(reported);
}

TEST_CASE("whoever is told may end it") {
  const TempFolder folder;
  const std::string path = folder.write("a.obj", obj());
  CHECK_THROWS_AS(read_mesh(path, [](double) { throw std::runtime_error("enough"); }), std::runtime_error);
}

TEST_CASE("a scene's loader names the mesh file") {
  const TempFolder folder;
  const std::string mesh = folder.write("a.obj", obj());
  const std::string scene = folder.write("scene.xml",
                                         "<scene version=\"3.0.0\"><sensor type=\"perspective\"/><shape type=\"obj\">"
                                         "<string name=\"filename\" value=\"a.obj\"/></shape></scene>");
  for (const std::string& path : {mesh, scene}) {
    std::string named;
    LoadOptions options;
    options.progress = [&](const std::string& file, double) { named = file; };
    static_cast<void>(load_scene(path, options));
    CHECK(named.ends_with("a.obj"));
  }
}

}  // namespace
}  // namespace strahl
