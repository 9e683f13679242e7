// SPDX-License-Identifier: MIT
// rusticl ends the loops of work-items after 65,535 turns in sum. Pictures and hits are right nevertheless: what was
// cut short is asked again, by itself where need be, and told where that does not help either.
#include <catch2/catch.hpp>
#include <random>

#include "errors.h"
#include "render/intersector.h"
#include "render/stage.h"
#include "study/generated/scenes.h"

namespace strahl::test {
namespace {

/// What the canary finds there (trust/canary_loops.h).
constexpr std::uint64_t turns = 65534;

RenderSettings watched() {
  RenderSettings settings;
  settings.precision = Precision::stable;
  settings.loop_turns = turns;
  settings.passes = 1;
  return settings;
}

/// As many stacks of triangles as a row has pixels, across all of the stage: the ray through a pixel's middle is in all
/// boxes of its stack and meets nothing but a wall behind. Of unlike sizes and places, so that neighbours take unlike
/// ways.
Mesh slats(int count, int columns) {
  Mesh mesh;
  std::mt19937 random(1);
  const double width = 2 * half_width / columns;
  for (int i = 0; i < count * columns; ++i) {
    const double x0 = -half_width + width * (i % columns), x1 = x0 + width;
    const double z = static_cast<double>(random() % 100'000) / 100'000,
                 size = 1 - static_cast<double>(random() % 16) / 32;
    const auto first = static_cast<int>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(),
                          {{x0, -0.3 * size, z}, {x1, 0.9 * size, z}, {x1, 0.9 * size - 0.01, z}});
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  const auto wall = static_cast<int>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), {{-9, -9, -1}, {9, -9, -1}, {0, 9, -1}});
  mesh.triangles.push_back({wall, wall + 1, wall + 2});
  return mesh;
}

/// One row of pixels. A filter so narrow that every sample is in the middle.
Scene row_of_slats(int count, int columns, int spp) {
  Scene scene = stage({slats(count, columns)});
  scene.integrator.name = "depth";
  scene.sampler.kind = SamplerKind::sobol;
  scene.film.filter = {FilterKind::box, 0.01};
  scene.film.width = columns;
  scene.film.height = 1;
  scene.sampler.sample_count = spp;
  return scene;
}

Ray through_middle(int column, int columns) {
  return {{half_width * ((2.0 * column + 1) / columns - 1), 0, 4}, {0, 0, -1}};
}

}  // namespace

TEST_CASE("a mesh in a tree has PoCL's bits") {
  require_pocl_and_rusticl();
  Scene scene = terrain(20'000);
  scene.integrator.name = "depth";
  scene.film.width = 16;
  scene.film.height = 12;
  scene.sampler.sample_count = 16;
  const RenderResult result = render("llvmpipe", scene, watched());
  CHECK(result.stats.tree.nodes > 0);
  CHECK(lit_pixels(result.color) > 100);
  CHECK(same_bits(render("pocl", scene, watched()), result));
}

TEST_CASE("samples of more turns than a launch has are made in several") {
  require_pocl_and_rusticl();
  const Scene scene = row_of_slats(1500, 1, 64);
  const RenderResult result = render("llvmpipe", scene, watched());
  CHECK(result.stats.kernel_runs.size() > 4);
  CHECK(lit_pixels(result.color) == 1);
  CHECK(same_bits(render("pocl", scene, watched()), result));
}

TEST_CASE("so are samples that are all the same, more than a loop has turns") {
  require_pocl_and_rusticl();
  Scene scene = row_of_slats(1500, 1, 100'000);
  scene.sampler.kind = SamplerKind::centre;
  const RenderResult result = render("llvmpipe", scene, watched());
  CHECK(result.stats.kernel_runs.size() == 2);
  CHECK(lit_pixels(result.color) == 1);
  CHECK(same_bits(render("pocl", scene, watched()), result));
}

TEST_CASE("so are samples that count in several pixels, more than a launch of the second kernel has turns for") {
  require_pocl_and_rusticl();
  Scene scene = lamp_edge(700);
  scene.film.width = 6;
  scene.film.height = 5;
  const RenderResult result = render("llvmpipe", scene, watched());
  CHECK(lit_pixels(result.color) > 4);
  CHECK(same_bits(render("pocl", scene, watched()), result));
}

TEST_CASE("neighbours that have too few turns together are asked apart") {
  require_pocl_and_rusticl();
  constexpr int columns = 8;
  const Scene scene = row_of_slats(9000, columns, 1);
  const RenderResult result = render("llvmpipe", scene, watched());
  CHECK(result.stats.kernel_runs.size() == 2 * columns - 1);
  CHECK(lit_pixels(result.color) == columns);
  CHECK(same_bits(render("pocl", scene, watched()), result));

  std::vector<Ray> rays;
  for (int i = 0; i < columns; ++i) rays.push_back(through_middle(i, columns));
  const std::vector<Hit> expected = Intersector(Device::open("pocl"), scene, watched()).trace(rays);
  Intersector rusticl(Device::open("llvmpipe"), scene, watched());
  const std::vector<Hit> hits = rusticl.trace(rays), any = rusticl.trace(rays, true);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    CHECK(expected[i].t == 5);
    CHECK(hits[i].t == expected[i].t);
    CHECK(hits[i].primitive == expected[i].primitive);
    CHECK(any[i].t == 0);
  }
}

TEST_CASE("a sample or a ray that takes more turns by itself is told") {
  require_pocl_and_rusticl();
  const Scene scene = row_of_slats(30'000, 1, 1);
  CHECK_THROWS_AS(render("llvmpipe", scene, watched()), NoDeviceError);
  Intersector rusticl(Device::open("llvmpipe"), scene, watched());
  for (const bool any_hit : {false, true})
    CHECK_THROWS_AS(rusticl.trace({through_middle(0, 1)}, any_hit), NoDeviceError);
  // Where the way is short it does not matter how many there are.
  CHECK(rusticl.trace({{{8, 8, 4}, {0, 0, -1}}}).front().shape == -1);
}

}  // namespace strahl::test
