// SPDX-License-Identifier: MIT
// Scenes made by code: as many primitives as they say, valid, the same everywhere, and SPD's where they are SPD's. 1 s.
#include <catch2/catch.hpp>
#include <cstring>
#include <map>

#include "scene/validate.h"
#include "study/generated/scenes.h"

using namespace strahl;

namespace {

int primitives(const Scene& scene) {
  int count = 0;
  for (const Shape& shape : scene.shapes) count += primitive_count(shape);
  return count;
}

/// FNV-1a over the bits of every coordinate.
std::uint64_t checksum(const Scene& scene) {
  std::uint64_t sum = 0xcbf29ce484222325u;
  const auto add = [&sum](double value) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    sum = (sum ^ bits) * 0x100000001b3u;
    if (static_cast<double>(static_cast<float>(value)) != value) FAIL("no float: " << value);
  };
  const auto add_vec = [&add](const Vec3& v) {
    add(v.x);
    add(v.y);
    add(v.z);
  };
  for (const Shape& shape : scene.shapes) {
    if (const auto* sphere = std::get_if<Sphere>(&shape.geometry)) {
      add_vec(sphere->center);
      add(sphere->radius);
    } else if (const auto* box = std::get_if<Box>(&shape.geometry)) {
      add_vec(box->min);
      add_vec(box->max);
    } else if (const auto* mesh = std::get_if<Mesh>(&shape.geometry)) {
      for (const Vec3& p : mesh->positions) add_vec(p);
      for (const auto& [a, b, c] : mesh->triangles) {
        add(a);
        add(b);
        add(c);
      }
    }
  }
  return sum;
}

}  // namespace

TEST_CASE("every generated scene is valid, in floats, of the size it says, and the same everywhere") {
  const std::map<std::string, std::pair<int, std::uint64_t>> known{
      {"sphereflake-0", {2, 0x745767f9dce13f5u}},  {"sphereflake-4", {7382, 0xaec0c1fd00263a35u}},
      {"terrain-2", {2, 0x289875b1c7b6a32du}},     {"terrain-10000", {10082, 0x7df42d656d6e6ebdu}},
      {"tetra-1", {4, 0x7c0a3fd7003c2305u}},       {"tetra-6", {4096, 0x94b0a86af0b9a325u}},
      {"lattice-16", {4096, 0xaef48ca270b9a325u}}, {"ten", {11, 0x4cac9e0cf0f65c45u}},
  };
  for (const auto& [name, expected] : known) {
    INFO(name);
    const Scene scene = generated_scene(name);
    CHECK(scene.name == name);
    CHECK(validate(scene).empty());
    CHECK(primitives(scene) == expected.first);
    CHECK(checksum(scene) == expected.second);
  }
}

TEST_CASE("a name that is no scene's is answered with those that are") {
  CHECK_THROWS_WITH(generated_scene("teapot-3"), Catch::Contains("sphereflake-DEPTH"));
  CHECK_THROWS_WITH(generated_scene("terrain-1"), Catch::Contains("from 2 to"));
  CHECK_THROWS_WITH(generated_scene("terrain-12x"), Catch::Contains("is a number"));
}
