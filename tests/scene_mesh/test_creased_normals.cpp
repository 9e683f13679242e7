// SPDX-License-Identifier: MIT
// Normals that are smooth but for edges sharper than an angle.
#include <catch2/catch.hpp>
#include <cmath>

#include "scene/meshes/creased_normals.h"

using namespace strahl;

namespace {

/// Two triangles at a right angle along the z axis; the second's corners there are vertices of their own.
Mesh corner_of_a_box() {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {0, 0, 0}, {0, 0, 1}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}, {3, 4, 5}};
  mesh.normals.assign(6, Vec3{1, 0, 0});
  mesh.attributes = {{"vertex_color", {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}, {4, 4, 4}, {5, 5, 5}}},
                     {"face_color", {{7, 7, 7}, {8, 8, 8}}}};
  return mesh;
}

Vec3 normal_at(const Mesh& mesh, std::size_t triangle, std::size_t corner) {
  return mesh.normals[static_cast<std::size_t>(mesh.triangles[triangle].at(corner))];
}

}  // namespace

TEST_CASE("a sharp edge keeps the faces' normals, a blunt one shares theirs") {
  Mesh sharp = corner_of_a_box();
  make_creased_normals(sharp, 89.9);
  CHECK(sharp.positions.size() == 6);
  for (std::size_t corner = 0; corner < 3; ++corner) {
    CHECK(normal_at(sharp, 0, corner) == Vec3{0, -1, 0});
    CHECK(normal_at(sharp, 1, corner) == Vec3{-1, 0, 0});
  }
  Mesh blunt = corner_of_a_box();
  make_creased_normals(blunt, 90.1);
  CHECK(blunt.positions.size() == 4);
  const Vec3 shared = normal_at(blunt, 0, 0);
  CHECK(shared.x == Approx(-std::sqrt(0.5)));
  CHECK(shared.y == Approx(-std::sqrt(0.5)));
  CHECK(normal_at(blunt, 1, 0) == shared);
  CHECK(normal_at(blunt, 0, 1) == Vec3{0, -1, 0});
}

TEST_CASE("vertices take along what the mesh has at them, and other texture coordinates part them") {
  Mesh mesh = corner_of_a_box();
  make_creased_normals(mesh, 180);
  REQUIRE(mesh.attributes[0].values.size() == mesh.positions.size());
  for (std::size_t corner = 0; corner < 3; ++corner) {
    const auto vertex = static_cast<std::size_t>(mesh.triangles[1].at(corner));
    CHECK(mesh.positions[vertex] == corner_of_a_box().positions[3 + corner]);
  }
  CHECK(mesh.attributes[1].values.size() == 2);
  Mesh parted = corner_of_a_box();
  parted.uvs = {{0, 0}, {1, 0}, {0, 1}, {0.5, 0}, {0.5, 1}, {1, 1}};
  make_creased_normals(parted, 180);
  CHECK(parted.positions.size() == 6);
  CHECK(parted.uvs.size() == 6);
  CHECK(normal_at(parted, 1, 0) == Vec3{-1, 0, 0});
}
