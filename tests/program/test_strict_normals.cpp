// SPDX-License-Identifier: MIT
// The feature STRICT_NORMALS: of a scene that asks for it, where a mesh has normals of its own and light is reflected.
#include <catch2/catch.hpp>

#include "program/features.h"

namespace strahl::test {

TEST_CASE("strict normals are for smooth meshes under integrators that reflect light") {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}};
  Scene scene;
  scene.shapes.emplace_back();
  scene.shapes[0].geometry = mesh;
  scene.lights = {{{}, ConstantLight{{1, 1, 1}}, {}}};
  const auto is_strict = [&](const char* integrator) {
    scene.integrator.name = integrator;
    return features_of(scene, {}).flag("STRICT_NORMALS");
  };
  scene.integrator.strict_normals = true;
  CHECK_FALSE(is_strict("path"));
  std::get<Mesh>(scene.shapes[0].geometry).normals.assign(3, Vec3{0, 0, 1});
  for (const char* name : {"direct", "path", "whitted", "volpath", "ptracer", "bdpt"}) CHECK(is_strict(name));
  for (const char* name : {"normals", "ao"}) CHECK_FALSE(is_strict(name));
  scene.integrator.strict_normals = false;
  CHECK_FALSE(is_strict("path"));
}

}  // namespace strahl::test
