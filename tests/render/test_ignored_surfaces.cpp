// SPDX-License-Identifier: MIT
// Surfaces of glass that are ignored where shapes with a priority overlap, and masks and blends on them: each of these
// is drawn for itself. 5 s.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "render/stage.h"
#include "scene/model/build.h"
#include "scene/scene_text.h"

namespace strahl::test {
namespace {

/// Of the index around it, behind a mask.
Material veiled(const Rgb& transmittance) {
  Material material;
  material.bsdf = Dielectric{1, 1, {{1, 1, 1}}, {transmittance}};
  material.opacity = Reflectance{{0.5, 0.5, 0.5}};
  return material;
}

void add_plate(Scene& scene, const Material& material, double from, double to, int priority) {
  Shape shape;
  shape.geometry = Box{{-9, -9, from}, {9, 9, to}};
  shape.material = static_cast<int>(scene.materials.size());
  shape.priority = priority;
  scene.materials.push_back(material);
  add(scene, shape);
}

// From above: into the black one, into the clear one, which is ignored there, and out of both. A hole in each of the
// black one's two faces lets light through.
TEST_CASE("a mask behind a surface that is ignored is drawn for itself") {
  require_pocl();
  Scene scene = stage({});
  add_plate(scene, veiled({0, 0, 0}), -0.5, 1, 2);
  add_plate(scene, veiled({1, 1, 1}), -1, 0, 1);
  add(scene, ConstantLight{{1, 1, 1}});
  scene.integrator.max_depth = 16;
  scene.integrator.rr_depth = 16;
  scene.sampler.kind = SamplerKind::independent;
  scene.sampler.sample_count = 64;
  for (const char* integrator : {"path", "whitted", "volpath"}) {
    INFO(integrator);
    scene.integrator.name = integrator;
    const Image image = color(scene);
    double sum = 0;
    for (std::size_t i = 0; i < image.data.size(); i += 3) sum += static_cast<double>(image.data[i]);
    const double samples = 64.0 * stage_size * stage_size;
    CHECK(3 * sum / static_cast<double>(image.data.size()) == Approx(0.25).margin(4 * std::sqrt(0.1875 / samples)));
  }
}

// Above the black plate, and apart from it, a clear one of a higher priority, whose vertex normals point outwards and
// whose triangles, mirrored, do not. What is behind the clear one is not within it.
TEST_CASE("the vertex normals of a mesh of glass say what is within it") {
  require_pocl();
  const SceneFolder folder;
  folder.write("plate.ply",
               "ply\nformat ascii 1.0\nelement vertex 8\nproperty float x\nproperty float y\nproperty float z\n"
               "property float nx\nproperty float ny\nproperty float nz\n"
               "element face 2\nproperty list uchar int vertex_indices\nend_header\n"
               "-9 -9 1 0 0 1\n9 -9 1 0 0 1\n9 9 1 0 0 1\n-9 9 1 0 0 1\n"
               "-9 -9 0.5 0 0 -1\n-9 9 0.5 0 0 -1\n9 9 0.5 0 0 -1\n9 -9 0.5 0 0 -1\n4 0 1 2 3\n4 4 5 6 7\n");
  const auto body = [](const std::string& shape, int priority, const std::string& transmittance) {
    return "<shape " + shape + "<integer name=\"priority\" value=\"" + std::to_string(priority) +
           "\"/><bsdf type=\"dielectric\"><float name=\"int_ior\" value=\"1\"/><float name=\"ext_ior\" value=\"1\"/>"
           "<float name=\"specular_transmittance\" value=\"" +
           transmittance + "\"/></bsdf></shape>";
  };
  const std::string clear =
      "type=\"ply\"><string name=\"filename\" value=\"plate.ply\"/>"
      "<transform name=\"to_world\"><scale x=\"-1\"/></transform>";
  const std::string black =
      "type=\"box\"><point name=\"min\" value=\"-9 -9 -1\"/><point name=\"max\" value=\"9 9 0\"/>";
  const Scene loaded = load_scene(folder.write("scene.xml", around(body(clear, 2, "1") + body(black, 1, "0")))).scene;
  Scene scene = stage({});
  scene.materials = loaded.materials;
  scene.shapes = loaded.shapes;
  add(scene, ConstantLight{{1, 1, 1}});
  for (const char* integrator : {"path", "whitted", "volpath"}) {
    INFO(integrator);
    scene.integrator.name = integrator;
    const Image image = color(scene);
    CHECK(*std::max_element(image.data.begin(), image.data.end()) == 0);
    scene.shapes.pop_back();
    CHECK(lit_pixels(color(scene)) == stage_size * stage_size);
    scene.shapes.push_back(loaded.shapes.back());
  }
}

// Half of the rays see the plate's faces from one side and its vertex normals from the other.
TEST_CASE("strict_normals does not end paths at a surface that is ignored") {
  require_pocl();
  Mesh plate;
  plate.positions = {{-9, -9, 0.5},  {9, -9, 0.5},  {9, 9, 0.5},  {-9, 9, 0.5},
                     {-9, -9, -0.5}, {9, -9, -0.5}, {9, 9, -0.5}, {-9, 9, -0.5}};
  plate.triangles = {{0, 1, 2}, {0, 2, 3}, {4, 6, 5}, {4, 7, 6}};
  for (int i = 0; i < 8; ++i) plate.normals.push_back(normalized({1, 0, i < 4 ? 0.01 : -0.01}));
  Material clear;
  clear.bsdf = Dielectric{1, 1, {{1, 1, 1}}, {{1, 1, 1}}};
  Scene scene = stage({});
  Shape shape;
  shape.geometry = plate;
  shape.material = static_cast<int>(scene.materials.size());
  shape.priority = 1;
  scene.materials.push_back(clear);
  add(scene, shape);
  add_plate(scene, clear, -1, 1, 2);
  add(scene, ConstantLight{{1, 1, 1}});
  scene.camera = perspective_camera({0, 0, 4}, {0, 0, 0}, {0, 1, 0}, 60);
  scene.integrator.strict_normals = true;
  for (const char* integrator : {"path", "whitted", "volpath"}) {
    INFO(integrator);
    scene.integrator.name = integrator;
    CHECK(lit_pixels(color(scene)) == stage_size * stage_size);
  }
}

}  // namespace
}  // namespace strahl::test
