// SPDX-License-Identifier: MIT
// --aov normal and geo_normal: vertex normals turn the first and not the second, in a mirroring instance as well; both
// are the same on a round shape, and the sides that flip_normals changes.
#include <catch2/catch.hpp>
#include <cmath>

#include "render/pictures.h"
#include "scene/scene_text.h"

namespace strahl::test {
namespace {

/// Two balls at the left and in the middle, the first of them turned; at the right a triangle whose vertex normals lean
/// towards +x, in an instance that mirrors x and turns the triangle to lean over y.
Scene three_shapes() {
  const SceneFolder folder;
  folder.write("t.obj", "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nvn 0.6 0 0.8\nf 1//1 2//1 3//1\n");
  const std::string text =
      "<scene version=\"3.0.0\"><integrator type=\"normals\"/><sensor type=\"orthographic\"><transform "
      "name=\"to_world\">"
      "<scale x=\"3\" y=\"3\"/><lookat origin=\"0,0,9\" target=\"0,0,0\" up=\"0,1,0\"/></transform></sensor>"
      "<shape type=\"sphere\"><point name=\"center\" value=\"-2,0,0\"/><boolean name=\"flip_normals\" "
      "value=\"true\"/></shape>"
      "<shape type=\"sphere\"/><shape type=\"shapegroup\" id=\"g\"><shape type=\"obj\"><string name=\"filename\" "
      "value=\"t.obj\"/></shape></shape><shape type=\"instance\"><ref id=\"g\"/><transform name=\"to_world\">"
      "<scale x=\"-1\"/><rotate x=\"1\" angle=\"-30\"/><translate x=\"2\"/></transform></shape></scene>";
  Scene scene = load_scene(folder.write("scene.xml", text)).scene;
  scene.film.width = 30;
  scene.film.height = 30;
  scene.sampler.sample_count = 1;
  scene.sampler.kind = SamplerKind::centre;
  return scene;
}

Vec3 at(const Image& image, const std::string& layer, int x, int y) {
  const auto value = [&](const char* axis) { return double{image.at(x, y, channel_of(image, layer + axis))}; };
  return {value(".X"), value(".Y"), value(".Z")};
}

bool is_near(const Vec3& a, const Vec3& b) { return length(a - b) < 1e-6; }

}  // namespace

TEST_CASE("normals of surfaces, and of their shading, in world space") {
  const Scene scene = three_shapes();
  for (const int lanes : {1, 16}) {
    INFO(lanes << " lanes");
    RenderSettings settings;
    settings.aovs = {Aov::normal, Aov::geo_normal};
    settings.lanes = lanes;
    const Image image = render("pocl", scene, settings).aov;
    // Pixel (15, 15)'s middle is (0.1, -0.1) off the picture's, in units of the scene.
    const double z = std::sqrt(1 - 0.02), s = std::sin(M_PI / 6), c = std::cos(M_PI / 6);
    CHECK(is_near(at(image, "geo_normal", 15, 15), {0.1, -0.1, z}));
    CHECK(is_near(at(image, "normal", 15, 15), {0.1, -0.1, z}));
    CHECK(is_near(at(image, "geo_normal", 5, 15), {-0.1, 0.1, -z}));
    CHECK(is_near(at(image, "normal", 5, 15), {-0.1, 0.1, -z}));
    CHECK(is_near(at(image, "geo_normal", 25, 15), {0, s, c}));
    CHECK(is_near(at(image, "normal", 25, 15), {-0.6, 0.8 * s, 0.8 * c}));
    CHECK(at(image, "geo_normal", 0, 0) == Vec3{});
  }
}

}  // namespace strahl::test
