// SPDX-License-Identifier: MIT
// A cloud is its spheres, bit for bit: lit, emitting, flipped and instanced. Only what counts shapes differs. 4 s.
#include <algorithm>
#include <catch2/catch.hpp>
#include <random>

#include "render/pictures.h"
#include "scene/model/transforms.h"

namespace strahl::test {
namespace {

constexpr int balls_of_each = 40;

std::vector<SphereCloud::Ball> some_balls(unsigned seed, double most) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(-2, 2), size(0.05, most);
  std::vector<SphereCloud::Ball> balls;
  for (int i = 0; i < balls_of_each; ++i)
    balls.push_back({{place(random), place(random), place(random)}, size(random)});
  return balls;
}

Shape shape_of(const Geometry& geometry, const std::optional<Rgb>& radiance, bool flip) {
  Shape shape;
  shape.geometry = geometry;
  shape.radiance = radiance;
  shape.flip_normals = flip;
  return shape;
}

/// As one cloud, or a shape for each sphere.
void add(std::vector<Shape>& shapes, const std::vector<SphereCloud::Ball>& balls, bool as_cloud,
         const std::optional<Rgb>& radiance = {}, bool flip = false) {
  if (as_cloud) return shapes.push_back(shape_of(SphereCloud{balls}, radiance, flip));
  for (const auto& [center, radius] : balls) shapes.push_back(shape_of(Sphere{center, radius}, radiance, flip));
}

Scene scene_of(bool as_cloud) {
  Scene scene = small_scene(scene_folder / "lecture/lit.xml", 96, 72, 8);
  scene.integrator.name = "path";
  scene.shapes.clear();
  scene.camera.world_from_camera = look_at({0, 1, 9}, {0, 0, 0}, {0, 1, 0}).value();
  add(scene.shapes, some_balls(1, 0.4), as_cloud);
  add(scene.shapes, some_balls(2, 0.1), as_cloud, Rgb{4, 3, 2});
  add(scene.shapes, some_balls(3, 0.2), as_cloud, Rgb{1, 2, 3}, true);
  Group& group = scene.groups.emplace_back();
  add(group.shapes, some_balls(4, 0.3), as_cloud);
  Instance& instance = scene.instances.emplace_back();
  instance.world_from_group.m[0][3] = 1.5;
  return scene;
}

TEST_CASE("the same picture as of single spheres, each a primitive of its cloud") {
  require_pocl();
  const RenderResult cloud = render("pocl", scene_of(true), all_aovs());
  const RenderResult single = render("pocl", scene_of(false), all_aovs());
  CHECK(lit_pixels(cloud.color) > 500);
  CHECK(same_bits(cloud.color, single.color));
  REQUIRE(cloud.aov.channels == single.aov.channels);
  const auto channel = [&](const std::string& name) {
    const auto& names = cloud.aov.channels;
    const auto found = std::find_if(names.begin(), names.end(), [&](const auto& n) { return n.starts_with(name); });
    REQUIRE(found != names.end());
    return static_cast<int>(found - names.begin());
  };
  const int shape = channel("shape_id"), primitive = channel("primitive_id");
  std::size_t seen = 0, wrong = 0;
  for (int y = 0; y < cloud.aov.height; ++y)
    for (int x = 0; x < cloud.aov.width; ++x) {
      const auto ours = [&](int c) { return cloud.aov.at(x, y, c); };
      const auto theirs = [&](int c) { return single.aov.at(x, y, c); };
      seen += theirs(shape) >= 0 ? 1U : 0U;
      for (int c = 0; c < static_cast<int>(cloud.aov.channels.size()); ++c)
        if (c != shape && c != primitive &&
            std::memcmp(&cloud.aov.data[cloud.aov.index(x, y, c)], &single.aov.data[single.aov.index(x, y, c)], 4) != 0)
          ++wrong;
      const float counted = ours(shape) < 0 ? ours(shape) : balls_of_each * ours(shape) + ours(primitive);
      if (counted != theirs(shape)) ++wrong;
    }
  CHECK(seen > 1000);
  CHECK(wrong == 0);
}

TEST_CASE("nor does a sphere of a cloud shade itself in the fast tier", "[slow]") {
  require_pocl();
  const RenderResult cloud = render("pocl", scene_of(true), all_aovs(Precision::fast));
  CHECK(same_bits(cloud.color, render("pocl", scene_of(false), all_aovs(Precision::fast)).color));
}

}  // namespace
}  // namespace strahl::test
