// SPDX-License-Identifier: MIT
// Other people's mesh files against expected_meshes.csv: verdict, number of different positions that triangles use,
// triangles, skipped faces, or where and how the first error begins. The numbers were compared with those of assimp
// 5.2.5 (Triangulate, JoinIdenticalVertices); the note of a row says where that one differs and why.
// Exit code 77 where ../shared is absent.
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <tuple>

#include "scene/meshes/mesh_file.h"
#include "support/needs.h"

namespace {
const strahl::test::Needs needs(STRAHL_SOURCE_DIR "/../shared/data");
}

namespace strahl {
namespace {

const std::filesystem::path data = STRAHL_SOURCE_DIR "/../shared/data";

struct Row {
  std::string path, verdict, vertices, triangles, skipped, says;
};

std::vector<Row> expected_rows() {
  std::ifstream file(STRAHL_SOURCE_DIR "/tests/scene_mesh/expected_meshes.csv");
  std::string line;
  std::getline(file, line);
  REQUIRE(line == "path,verdict,vertices,triangles,skipped,says,note");
  std::vector<Row> rows;
  while (std::getline(file, line)) {
    std::istringstream cells(line);
    Row row;
    for (std::string* cell : {&row.path, &row.verdict, &row.vertices, &row.triangles, &row.skipped, &row.says}) {
      REQUIRE(std::getline(cells, *cell, ','));
    }
    rows.push_back(row);
  }
  return rows;
}

std::size_t positions_in_use(const Mesh& mesh) {
  std::set<std::tuple<double, double, double>> positions;
  for (const auto& triangle : mesh.triangles) {
    for (int vertex : triangle) {
      const Vec3& p = mesh.positions.at(static_cast<std::size_t>(vertex));
      positions.emplace(p.x, p.y, p.z);
    }
  }
  return positions.size();
}

TEST_CASE("every mesh file of others gives what the table says") {
  for (const Row& row : expected_rows()) {
    INFO(row.path);
    if (row.verdict == "ok") {
      const MeshFile file = read_mesh((data / row.path).string());
      CHECK(std::to_string(positions_in_use(file.mesh)) == row.vertices);
      CHECK(std::to_string(file.mesh.triangles.size()) == row.triangles);
      CHECK(std::to_string(file.skipped_faces) == row.skipped);
      CHECK((file.mesh.normals.empty() || file.mesh.normals.size() == file.mesh.positions.size()));
      CHECK((file.mesh.uvs.empty() || file.mesh.uvs.size() == file.mesh.positions.size()));
      CHECK(file.mesh.part_of_triangle.size() == (file.materials.empty() ? 0 : file.mesh.triangles.size()));
      for (int part : file.mesh.part_of_triangle) {
        REQUIRE(part >= 0);
        REQUIRE(static_cast<std::size_t>(part) < file.materials.size());
      }
    } else {
      REQUIRE(row.verdict == "error");
      REQUIRE_FALSE(row.says.empty());
      try {
        static_cast<void>(read_mesh((data / row.path).string()));
        FAIL_CHECK("it loads");
      } catch (const SceneError& error) {
        const auto& all = error.diagnostics();
        const auto first = std::ranges::find(all, Severity::error, &Diagnostic::severity);
        REQUIRE(first != all.end());
        const std::string text = first->text().substr(first->where.file.size());
        CHECK(text.substr(0, row.says.size()) == row.says);
      }
    }
  }
}

TEST_CASE("the table names every OBJ and PLY file") {
  std::set<std::string> listed, present;
  for (const Row& row : expected_rows()) listed.insert(row.path);
  for (const char* folder : {"tinyobj", "malformed", "meshes", "cornell", "sionna"}) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(data / folder)) {
      const std::string extension = entry.path().extension().string();
      if (extension != ".obj" && extension != ".ply") continue;
      present.insert(std::filesystem::relative(entry.path(), data).string());
    }
  }
  CHECK(listed == present);
}

}  // namespace
}  // namespace strahl
