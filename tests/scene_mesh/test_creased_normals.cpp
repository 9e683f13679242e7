// SPDX-License-Identifier: MIT
// Normals that are smooth but for edges sharper than an angle.
#include <algorithm>
#include <catch2/catch.hpp>
#include <chrono>
#include <cmath>
#include <limits>
#include <map>
#include <random>

#include "scene/meshes/creased_normals.h"

using namespace strahl;

namespace {

/// Two triangles at a right angle along the z axis; the second's corners there are vertices of their own.
Mesh corner_of_a_box() {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {0, 0, 0}, {0, 0, 1}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}, {3, 4, 5}};
  mesh.normals.assign(6, Vec3{1, 0, 0});
  mesh.attributes = {{"vertex_color", {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {0, 0, 0}, {2, 2, 2}, {5, 5, 5}}},
                     {"face_color", {{7, 7, 7}, {8, 8, 8}}}};
  return mesh;
}

/// Triangles around the z axis, each of them turned about its own middle by up to `degrees`.
Mesh fan(int count, double degrees) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}};
  std::mt19937 random(1);
  std::uniform_real_distribution<double> slope(-std::tan(degrees * std::acos(-1) / 180),
                                               std::tan(degrees * std::acos(-1) / 180));
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::acos(-1) * i / count, across = 1.0 / count, tilt = slope(random);
    const Vec3 middle{std::cos(angle), std::sin(angle), slope(random)};
    const Vec3 side{-across * std::sin(angle), across * std::cos(angle), across * tilt};
    mesh.positions.push_back(middle - side);
    mesh.positions.push_back(middle + side);
    mesh.triangles.push_back({0, 2 * i + 1, 2 * i + 2});
  }
  return mesh;
}

Vec3 unit_normal(const Mesh& mesh, std::size_t triangle) {
  const auto at = [&](std::size_t i) {
    return mesh.positions[static_cast<std::size_t>(mesh.triangles[triangle].at(i))];
  };
  return normalized(cross(at(1) - at(0), at(2) - at(0)));
}

/// Of each triangle of a fan the one with the first corner of its group in the middle, with a look at every pair.
std::vector<std::size_t> first_of_group(const Mesh& mesh, double degrees) {
  const double least = std::cos(degrees * std::acos(-1) / 180);
  std::vector<std::size_t> firsts, of_triangle;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const Vec3 normal = unit_normal(mesh, i);
    const auto is_near = [&](std::size_t first) { return dot(unit_normal(mesh, first), normal) >= least; };
    const auto found = std::find_if(firsts.begin(), firsts.end(), is_near);
    of_triangle.push_back(found == firsts.end() ? i : *found);
    if (found == firsts.end()) firsts.push_back(i);
  }
  return of_triangle;
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

/// One vertex for both would show the first triangle's colour on the second one.
TEST_CASE("other attributes part vertices as well, also such as nothing shows for they are not finite") {
  const double none = std::numeric_limits<double>::quiet_NaN();
  Mesh mesh = corner_of_a_box();
  const Rgb red{1, 0, 0}, green{0, 1, 0};
  mesh.attributes[0].values = {red, red, red, green, green, green};
  mesh.attributes.push_back({"vertex_heat", std::vector<Rgb>(6, {none, none, none})});
  make_creased_normals(mesh, 180);
  REQUIRE(mesh.positions.size() == 6);
  for (std::size_t triangle = 0; triangle < 2; ++triangle)
    for (const int vertex : mesh.triangles[triangle])
      CHECK(mesh.attributes[0].values.at(static_cast<std::size_t>(vertex)) == (triangle == 0 ? red : green));
  mesh = corner_of_a_box();
  mesh.attributes.push_back({"vertex_heat", std::vector<Rgb>(6, {none, none, none})});
  make_creased_normals(mesh, 180);
  CHECK(mesh.positions.size() == 4);
}

TEST_CASE("around a vertex of many triangles groups are those that a look at every pair finds") {
  for (const double spread : {0.0, 1e-6, 0.5, 20.0, 80.0})
    for (const double degrees : {0.0, 1e-6, 0.01, 0.3, 4.0, 30.0, 120.0}) {
      INFO(spread << " apart, smooth within " << degrees);
      const Mesh before = fan(2000, spread);
      Mesh mesh = before;
      make_creased_normals(mesh, degrees);
      std::vector<std::size_t> firsts;
      std::map<int, std::size_t> first_of_vertex;
      for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
        firsts.push_back(first_of_vertex.try_emplace(mesh.triangles[i][0], i).first->second);
      CHECK(firsts == first_of_group(before, degrees));
    }
}

TEST_CASE("a vertex of very many triangles is no matter of hours") {
  Mesh mesh = fan(300'000, 60);
  const auto start = std::chrono::steady_clock::now();
  make_creased_normals(mesh, 0);
  CHECK(mesh.positions.size() == 900'000);
  CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(20));
}
