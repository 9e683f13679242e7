// SPDX-License-Identifier: MIT
// The last ray of a path is followed only where it may meet emission: pictures are those of the same scene with a plane
// that glows away from everything, which nobody sees, but because of which no ray is left out. 5 s.
#include <catch2/catch.hpp>

#include "oracle/random.h"
#include "packing/cl_layout.h"
#include "packing/pack.h"
#include "render/alike.h"
#include "render/stage.h"
#include "scene/model/build.h"

namespace strahl::test {
namespace {

Scene room(const std::vector<Geometry>& lamps, const char* integrator, int max_depth) {
  Scene scene = stage({floor_plane(), Sphere{{0.5, -0.3, 0.4}, 0.4}}, diffuse({0.7, 0.6, 0.5}, true));
  for (const Geometry& lamp : lamps) add(scene, emitting(lamp, {5, 4, 3}));
  scene.integrator.name = integrator;
  scene.integrator.max_depth = max_depth;
  scene.sampler.kind = SamplerKind::independent;
  scene.sampler.sample_count = 16;
  return scene;
}

Scene with_unseen_glow(Scene scene) {
  add(scene, emitting(Plane{{0, 0, -1}, {0, 0, -1}, {1, 0, 0}, {0, 1, 0}}, {1, 1, 1}));
  return scene;
}

std::int32_t header(const Scene& scene, int field) {
  const Features features = features_of(scene, {});
  PackOptions options;
  options.acceleration = Acceleration::list;
  return pack_scene<float>(scene, features, options).at(field);
}

constexpr int never = std::numeric_limits<int>::max();

/// Lamps of every kind that can be one, and where boxes around them are the least like them.
std::vector<std::vector<Geometry>> lamps() {
  Mesh mesh;
  mesh.positions = {{-1, -0.6, 1}, {0.2, 1, 0.7}, {1.1, -0.4, 1.4}, {1.3, 1.2, 2}};
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}};
  oracle::Random random(4);
  std::vector<Geometry> many;
  for (int i = 0; i < 40; ++i) {
    const Vec3 center{random.uniform(-3, 3), random.uniform(-2, 2), random.uniform(0.5, 3)};
    many.emplace_back(Sphere{center, random.uniform(0.02, 0.3)});
  }
  return {{Sphere{{0.3, -0.2, 1.2}, 0.5}},
          {Sphere{{0, 0.3, 2.5}, 1e-3}},
          {Sphere{{3e4, 2e4, 5e4}, 2e4}},
          {Disk{{0.2, 0, 1}, {0, 0.7, 0}, {0.7, 0, 0}}},
          {Rectangle{{-0.8, -0.5, 1.2}, {0.2, 1.1, 0.1}, {1.4, 0.1, 0.3}}},
          {Triangle{{-1, -0.6, 1}, {0.2, 1, 0.7}, {1.1, -0.4, 1.4}}},
          {mesh},
          many};
}

}  // namespace

TEST_CASE("the last ray of a path finds all light that it would find among everything") {
  require_pocl();
  for (const std::vector<Geometry>& of_scene : lamps())
    for (const auto& [integrator, max_depth] : {std::pair("direct", -1), std::pair("path", 2), std::pair("path", 4)}) {
      const Scene scene = room(of_scene, integrator, max_depth), open = with_unseen_glow(scene);
      INFO(integrator << ", max_depth " << max_depth << ", lamps " << of_scene.size() << ", kind "
                      << of_scene.front().index());
      CHECK(header(scene, layout::HEADER_LAST_DEPTH) == (max_depth < 0 ? 1 : max_depth - 1));
      CHECK(header(open, layout::HEADER_LAST_DEPTH) == never);
      CHECK(same_bits(color(scene), color(open)));
    }
}

TEST_CASE("rays are the last where nothing but emission counts for them, and it is bounded and within the scene") {
  const std::vector<Geometry> lamp = {Sphere{{0, 0, 2}, 0.5}};
  CHECK(header(room(lamp, "direct", 5), layout::HEADER_LAST_DEPTH) == 1);
  CHECK(header(room(lamp, "path", 5), layout::HEADER_LAST_DEPTH) == 4);
  for (const char* integrator : {"volpath", "whitted", "ao", "ptracer", "bdpt"})
    CHECK(header(room(lamp, integrator, 5), layout::HEADER_LAST_DEPTH) == never);
  Scene open = room(lamp, "path", 5);
  open.lights.push_back(light(ConstantLight{{0.1, 0.1, 0.1}}));
  CHECK(header(open, layout::HEADER_LAST_DEPTH) == never);
  CHECK(header(room(lamp, "path", 5), layout::HEADER_GLOWING_COUNT) == 1);
  CHECK(header(room(lamps().back(), "path", 5), layout::HEADER_GLOWING_COUNT) == 8);
}

}  // namespace strahl::test
