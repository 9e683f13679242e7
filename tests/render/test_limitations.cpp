// SPDX-License-Identifier: MIT
// A picture that will be empty is told before it is rendered; one that will not is not.
#include <algorithm>
#include <catch2/catch.hpp>

#include "render/limitations.h"

using namespace strahl;

namespace {

Scene scene_of(const std::string& integrator) {
  Scene scene;
  scene.integrator.name = integrator;
  scene.shapes.emplace_back().geometry = Sphere{};
  return scene;
}

/// What is said of an empty picture, or nothing.
std::string emptiness(const Scene& scene) {
  for (const Diagnostic& warning : limitations(scene))
    if (warning.message.find("emits light") != std::string::npos ||
        warning.message.find("no shape") != std::string::npos)
      return warning.message;
  return {};
}

const char* const lit_integrators[] = {"direct", "whitted", "path", "emission"};

}  // namespace

TEST_CASE("a scene without emitters is black where light is needed") {
  for (const char* integrator : lit_integrators)
    CHECK(emptiness(scene_of(integrator)).find(integrator) != std::string::npos);
  for (const char* integrator : {"normals", "depth", "ao"}) CHECK(emptiness(scene_of(integrator)).empty());
}

TEST_CASE("whatever emits ends the warning") {
  for (const char* integrator : lit_integrators) {
    const bool is_lit = std::string(integrator) != "emission";
    INFO(integrator);
    Scene lamp = scene_of(integrator), sky = lamp, point = lamp, sun = lamp, mesh = lamp;
    lamp.shapes.front().radiance = Rgb{0, 0, 1};
    CHECK(emptiness(lamp).empty());
    sky.lights.push_back({"", ConstantLight{}, {}});
    CHECK(emptiness(sky).empty());
    point.lights.push_back({"", PointLight{}, {}});
    CHECK(emptiness(point).empty() == is_lit);  // No ray meets a point.
    sun.lights.push_back({"", DirectionalLight{}, {}});
    CHECK(emptiness(sun).empty() == is_lit);
    Mesh glowing;
    glowing.parts.push_back({0, Rgb{1, 1, 1}});
    mesh.shapes.front().geometry = glowing;
    CHECK(emptiness(mesh).empty());
  }
}

TEST_CASE("a medium that emits ends the warning where the integrator goes through media") {
  Scene scene = scene_of("volpath");
  scene.media.emplace_back();
  CHECK_FALSE(emptiness(scene).empty());
  scene.media.back().emission = Rgb{0, 1, 0};
  CHECK(emptiness(scene).empty());
  scene.integrator.name = "path";
  CHECK_FALSE(emptiness(scene).empty());
  scene.integrator.name = "volpath";
  scene.media.back().sigma_t = Rgb{1, 0, 1};  // Where nothing is absorbed nothing is emitted.
  CHECK_FALSE(emptiness(scene).empty());
}

TEST_CASE("a lamp that no ray hits and that is never drawn is named") {
  const auto is_named = [](const char* integrator, double weight) {
    Scene scene = scene_of(integrator);
    scene.lights.push_back({"", PointLight{}, {}, weight});
    const std::vector<Diagnostic> all = limitations(scene);
    return std::any_of(all.begin(), all.end(), [](const Diagnostic& one) {
      return one.message.find("its sampling_weight is 0") != std::string::npos;
    });
  };
  for (const char* integrator : {"path", "volpath", "ptracer", "bdpt"}) {
    CHECK(is_named(integrator, 0));
    CHECK_FALSE(is_named(integrator, 0.5));
  }
  for (const char* integrator : {"direct", "whitted"}) CHECK_FALSE(is_named(integrator, 0));
  // Of shapes: rays find an area emitter, but not a beam; light paths alone find neither.
  const auto names_shape = [](const char* integrator, bool is_beam) {
    Scene scene = scene_of(integrator);
    Shape& shape = scene.shapes.front();
    (is_beam ? shape.exitance : shape.radiance) = Rgb{1, 1, 1};
    shape.sampling_weight = 0;
    for (const Diagnostic& one : limitations(scene))
      if (one.message.find("its sampling_weight is 0") != std::string::npos) return true;
    return false;
  };
  CHECK(names_shape("ptracer", false));
  CHECK(names_shape("ptracer", true));
  CHECK(names_shape("bdpt", true));
  CHECK_FALSE(names_shape("bdpt", false));
  CHECK_FALSE(names_shape("path", false));
}

TEST_CASE("beams are named where the integrator cannot find them") {
  const auto beams = [](Scene scene, const char* integrator) {
    scene.integrator.name = integrator;
    int count = 0;
    for (const Diagnostic& warning : limitations(scene))
      count += warning.message.find("light is left out: each of its places shines") != std::string::npos ? 1 : 0;
    return count;
  };
  Scene scene = scene_of("path");
  scene.shapes.front().exitance = Rgb{1, 1, 1};
  scene.lights.push_back({"", CollimatedLight{}, {}});
  for (const char* integrator : {"path", "direct", "whitted", "volpath"}) {
    INFO(integrator);
    CHECK(beams(scene, integrator) == 2);
  }
  for (const char* integrator : {"ptracer", "bdpt", "normals"}) CHECK(beams(scene, integrator) == 0);
  for (const char* integrator : {"path", "ptracer"}) {
    scene.integrator.name = integrator;
    CHECK(emptiness(scene).empty());
  }
  scene.lights.clear();
  scene.shapes.front().exitance = Rgb{0, 0, 0};
  CHECK(beams(scene, "path") == 0);
  CHECK_FALSE(emptiness(scene).empty());
}

TEST_CASE("an emitter of radiance 0 emits nothing") {
  Scene scene = scene_of("path");
  scene.shapes.front().radiance = Rgb{0, 0, 0};
  scene.lights.push_back({"", PointLight{{}, {0, 0, 0}}, {}});
  CHECK_FALSE(emptiness(scene).empty());
}

TEST_CASE("a scene without shapes, with and without instances") {
  Scene scene = scene_of("normals");
  scene.shapes.clear();
  CHECK(emptiness(scene).find("no shape") != std::string::npos);
  scene.groups.emplace_back().shapes.emplace_back();
  CHECK_FALSE(emptiness(scene).empty());  // A group that nobody places.
  scene.instances.emplace_back();
  CHECK(emptiness(scene).empty());
}

TEST_CASE("a shape too far off for single precision is named, with the remedy") {
  Scene scene = scene_of("path");
  scene.shapes.emplace_back().geometry = Sphere{{0, 0, 3e22}, 1e22};
  CHECK_FALSE(too_wide_for_single(scene));
  scene.shapes.back().geometry = Sphere{{0, 0, 3e28}, 1e28};
  scene.shapes.back().where = {"far.xml", 7, 3};
  const std::optional<Diagnostic> warning = too_wide_for_single(scene);
  REQUIRE(warning);
  CHECK(warning->text().find("far.xml:7:3: warning: this shape reaches to 4e+28") != std::string::npos);
  CHECK(warning->message.find("--precision double") != std::string::npos);
}
