// SPDX-License-Identifier: MIT
// Which primitives each part of a shape has.
#include <catch2/catch.hpp>
#include <chrono>

#include "packing/cl_layout.h"
#include "packing/pack.h"
#include "packing/shape_parts.h"
#include "scene/model/build.h"

using namespace strahl;

namespace {

std::vector<int> primitives(const Shape& shape, int part) {
  const PrimitivesOfParts parts(shape);
  const std::span<const int> of_part = parts.of(part);
  return {of_part.begin(), of_part.end()};
}

/// A row of triangles, each of a part of its own that shines.
Mesh lamps(int count) {
  Mesh mesh;
  mesh.positions.push_back({0, 0, 1});
  for (int i = 0; i < count; ++i) {
    const double x = i;
    mesh.positions.push_back({x, 0, 0});
    mesh.positions.push_back({x + 1, 1, 0});
    mesh.triangles.push_back({0, 2 * i + 1, 2 * i + 2});
    mesh.parts.push_back({0, Rgb{1, 1, 1}});
    mesh.part_of_triangle.push_back(count - 1 - i);
  }
  return mesh;
}

}  // namespace

TEST_CASE("a mesh's parts have its triangles in their order, a lamp of a cloud its sphere, others all they have") {
  Shape shape;
  Mesh mesh = lamps(5);
  mesh.part_of_triangle = {3, 0, 3, 1, 0};
  shape.geometry = mesh;
  CHECK(primitives(shape, 0) == std::vector<int>{1, 4});
  CHECK(primitives(shape, 1) == std::vector<int>{3});
  CHECK(primitives(shape, 2).empty());
  CHECK(primitives(shape, 3) == std::vector<int>{0, 2});
  mesh.parts.clear();
  shape.geometry = mesh;
  CHECK(primitives(shape, 0) == std::vector<int>{0, 1, 2, 3, 4});
  shape.geometry = SphereCloud{{{{0, 0, 0}, 1}, {{3, 0, 0}, 1}}};
  CHECK(primitives(shape, 0) == std::vector<int>{0, 1});
  shape.radiance = Rgb{1, 1, 1};
  CHECK(primitives(shape, 1) == std::vector<int>{1});
}

TEST_CASE("many parts that shine are packed in about the time of one") {
  Scene scene;
  scene.integrator.name = "path";
  add(scene, lamps(200'000));
  RenderSettings settings;
  settings.light_choice = "uniform";
  const Features features = features_of(scene, settings);
  PackOptions options{8, {}};
  options.acceleration = Acceleration::list;
  const auto start = std::chrono::steady_clock::now();
  const PackedScene<float> packed = pack_scene<float>(scene, features, options);
  CHECK(packed.index.at(layout::HEADER_LIGHT_COUNT) == 200'000);
  CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(10));
}
