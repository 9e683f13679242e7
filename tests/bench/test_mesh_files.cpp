// SPDX-License-Identifier: MIT
// The mesh files that loaders are timed on hold one surface, whatever their kind.
#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <optional>

#include "bench/mesh_files.h"
#include "errors.h"
#include "scene/meshes/mesh_file.h"

using namespace strahl;

namespace {

struct Folder {
  std::filesystem::path path;
  Folder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "strahl-test-XXXXXX").string();
    path = mkdtemp(pattern.data());
  }
  ~Folder() { std::filesystem::remove_all(path); }
};

/// Sums over corners, which no order of vertices and no splitting changes.
Vec3 sum_of_corners(const Mesh& mesh) {
  Vec3 sum;
  for (const auto& triangle : mesh.triangles)
    for (const int corner : triangle) sum = sum + mesh.positions.at(static_cast<std::size_t>(corner));
  return sum;
}

}  // namespace

TEST_CASE("every kind of file holds the same triangles") {
  const Folder folder;
  std::optional<Vec3> first;
  for (const std::string& kind : bench::mesh_kinds()) {
    INFO(kind);
    const std::string path = (folder.path / (kind + bench::extension_of(kind))).string();
    bench::write_mesh_file(path, kind, 700);
    const MeshFile file = read_mesh(path);
    CHECK(file.warnings.empty());
    CHECK(file.mesh.triangles.size() == 2 * 19 * 19);
    CHECK(file.mesh.positions.size() == (kind == "obj-corners" ? 3 * file.mesh.triangles.size() : 20 * 20));
    CHECK(file.mesh.normals.empty() == (kind.find("normals") == kind.npos && kind != "obj-corners"));
    const Vec3 sum = sum_of_corners(file.mesh);
    if (!first) first = sum;
    CHECK(length(sum - *first) < 1e-3);
  }
}

TEST_CASE("an unknown kind is refused by name") {
  CHECK_THROWS_AS(bench::write_mesh_file("a.stl", "stl", 1), UsageError);
  CHECK_FALSE(std::filesystem::exists("a.stl"));
}
