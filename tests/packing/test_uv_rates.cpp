// SPDX-License-Identifier: MIT
// The filter of a checkerboard never blurs more than it should: rates of u and v are those where they change least.
#include <catch2/catch.hpp>
#include <cmath>

#include "packing/uv_rates.h"

using namespace strahl;

namespace {

Vec2 rates(const Geometry& geometry) { return uv_rates(geometry, UploadFrame{{}, 1}); }

Mesh floor_of(std::vector<Vec3> positions, std::vector<std::array<int, 3>> triangles) {
  Mesh mesh;
  mesh.positions = std::move(positions);
  mesh.triangles = std::move(triangles);
  for (const Vec3& p : mesh.positions) mesh.uvs.push_back({p.x / 2, p.y / 4});
  return mesh;
}

}  // namespace

TEST_CASE("The rates of a mesh do not depend on how its triangles lie") {
  const std::vector<Vec3> corners{{0, 0, 0}, {8, 0, 0}, {8, 1, 0}, {0, 1, 0}};
  for (const auto& triangles : std::vector<std::vector<std::array<int, 3>>>{
           {{0, 1, 2}, {0, 2, 3}}, {{1, 2, 0}, {2, 3, 0}}, {{1, 2, 3}, {3, 0, 1}}}) {
    const Vec2 found = rates(floor_of(corners, triangles));
    CHECK(found.x == Approx(1.0 / 2));
    CHECK(found.y == Approx(1.0 / 4));
  }
  // Both edges of the sliver's first corner are along u.
  const Vec2 sliver = rates(floor_of({{0, 0, 0}, {8, 1e-6, 0}, {8, 0, 0}}, {{0, 1, 2}}));
  CHECK(sliver.x == Approx(1.0 / 2));
  CHECK(sliver.y == Approx(1.0 / 4));
}

TEST_CASE("The least stretched triangle gives the rates of a mesh; one without area gives none") {
  Mesh mesh = floor_of({{0, 0, 0}, {8, 0, 0}, {8, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}, {1, 1, 2}});
  CHECK(rates(mesh).x == Approx(1.0 / 2));
  mesh.uvs[3] = {0, 0};
  CHECK(rates(mesh).y == Approx(1.0 / 32));
  CHECK(rates(mesh).x == Approx(1.0 / 2));
  mesh.uvs[3] = {-100, 100};
  CHECK(rates(mesh).x == Approx(1.0 / 2));
  mesh.uvs[3] = mesh.uvs[2] = mesh.uvs[0];
  CHECK(rates(mesh).x == Approx(std::hypot(1.0 / 2, 4)));  // Of the other triangle.
  mesh.triangles = {{0, 2, 3}};
  CHECK(rates(mesh).x == 0);
  mesh.triangles = {{1, 1, 2}};
  CHECK(rates(mesh).x == 0);
}

TEST_CASE("A flat cube and a cloud are filtered as their largest part") {
  const Vec2 slab = rates(Cube{{0, 0, 0}, {{{10, 0, 0}, {0, 20, 0}, {0, 0, 0.01}}}});
  CHECK(slab.x == Approx(1.0 / 20));
  CHECK(slab.y == Approx(1.0 / 20));
  SphereCloud cloud;
  cloud.spheres = {{{0, 0, 0}, 0.001}, {{5, 0, 0}, 2}};
  const Vec2 ball = rates(Sphere{{}, 2}), balls = rates(cloud);
  CHECK(balls.x == ball.x);
  CHECK(balls.y == ball.y);
}
