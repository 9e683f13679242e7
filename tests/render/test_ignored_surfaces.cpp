// SPDX-License-Identifier: MIT
// Surfaces of glass that are ignored where shapes with a priority overlap, and masks and blends on them: each of these
// is drawn for itself. 5 s.
#include <catch2/catch.hpp>
#include <cmath>

#include "render/stage.h"
#include "scene/model/build.h"

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
  require_pocl_and_rusticl();
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

}  // namespace
}  // namespace strahl::test
