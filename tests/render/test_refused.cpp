// SPDX-License-Identifier: MIT
// Scenes, settings and goals made in C++ that cannot be rendered: each is refused as what it is, before anything is
// computed from it.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <limits>

#include "render/intersector.h"
#include "render/pictures.h"
#include "scene/model/build.h"

namespace strahl::test {
namespace {

using Catch::Matchers::Contains;

Device pocl() {
  require_pocl();
  return Device::open("pocl");
}

Scene lit_sphere() {
  Scene scene;
  scene.film.width = scene.film.height = 8;
  add(scene, Sphere{{0, 0, 5}, 1});
  add(scene, PointLight{});
  return scene;
}

template <class Change>
Scene changed(const Change& change) {
  Scene scene = lit_sphere();
  change(scene);
  return scene;
}

}  // namespace

TEST_CASE("a scene that is not valid is a SceneError, whatever would read it first") {
  const Device device = pocl();
  const auto refused = [&](const std::string& words, const Scene& scene) {
    INFO(words);
    CHECK_THROWS_AS(Renderer(device, scene), SceneError);
    CHECK_THROWS_WITH(Renderer(device, scene), Contains(words));
    CHECK_THROWS_AS(Renderer::is_program_cached(device, scene, {}), SceneError);
    CHECK_THROWS_AS(Intersector(device, scene), SceneError);
  };
  refused("no integrator", changed([](Scene& s) { s.integrator.name = "unknown"; }));
  refused("group 3", changed([](Scene& s) { add_instance(s, 3, Transform{}); }));
  refused("material 7", changed([](Scene& s) {
            s.integrator.name = "volpath";
            s.shapes[0].material = 7;
          }));
  refused("backs", changed([](Scene& s) {
            s.integrator.name = "volpath";
            s.materials[0].opacity = Reflectance{{0, 0, 0}};
            s.materials[0].back = 0;
          }));
  refused("sampling_weight", changed([](Scene& s) { s.lights[0].sampling_weight = -1; }));
  refused("sampling_weight",
          changed([](Scene& s) { s.shapes[0].sampling_weight = std::numeric_limits<double>::quiet_NaN(); }));
}

TEST_CASE("samples of a picture that cannot be are refused as the picture is") {
  const auto of = [](const Scene& scene) { Renderer::require_samples(scene, {}, {}); };
  CHECK_NOTHROW(of(lit_sphere()));
  CHECK_THROWS_AS(of(changed([](Scene& s) { s.integrator.name = "unknown"; })), SceneError);
  CHECK_THROWS_AS(of(changed([](Scene& s) { s.film.width = 0; })), SceneError);
}

TEST_CASE("a light choice that is none is named, with those that there are") {
  const Device device = pocl();
  RenderSettings settings;
  settings.light_choice = "echa";
  for (const int lights : {1, 2}) {
    const Scene scene = changed([&](Scene& s) {
      s.integrator.name = "path";
      s.lights.resize(static_cast<std::size_t>(lights), s.lights[0]);
    });
    CHECK_THROWS_AS(Renderer(device, scene, settings), UsageError);
    CHECK_THROWS_WITH(Renderer(device, scene, settings), Contains("did you mean \"each\"?") && Contains("uniform"));
    CHECK_THROWS_AS(Renderer::is_program_cached(device, scene, settings), UsageError);
  }
}

TEST_CASE("settings that cannot be are refused, with what may stand") {
  const Device device = pocl();
  Scene scene = lit_sphere();
  const auto refused = [&](const std::string& words, const auto& change) {
    INFO(words);
    RenderSettings settings;
    change(settings);
    CHECK_THROWS_AS(Renderer(device, scene, settings), UsageError);
    CHECK_THROWS_WITH(Renderer(device, scene, settings), Contains(words));
    CHECK_THROWS_AS(Renderer::is_program_cached(device, scene, settings), UsageError);
    CHECK_THROWS_AS(Renderer::require_samples(scene, settings, {}), UsageError);
    CHECK_THROWS_AS(Intersector(device, scene, settings), UsageError);
    CHECK_THROWS_AS(Intersector::least_memory(device, scene, settings), UsageError);
  };
  for (const int width : {0, 1, 3, 5, 7, 9, 32, -2})
    refused(fmt::format("bvh_width is {}; it can be 2, 4, 8 or 16", width),
            [&](RenderSettings& s) { s.bvh_width = width; });
  for (const int lanes : {0, 2, 4, 32, -8})
    refused(fmt::format("lanes is {}; it can be 1, 8 or 16", lanes), [&](RenderSettings& s) { s.lanes = lanes; });
  refused("lanes is 16 in double; it can be 1 or 8", [](RenderSettings& s) {
    s.precision = Precision::fp64;
    s.lanes = 16;
  });
  refused("bvh_width is 16 in double; it can be 2, 4 or 8", [](RenderSettings& s) {
    s.precision = Precision::fp64;
    s.bvh_width = 16;
  });
  refused("a bvh_width of 4 tests 1 at a time, and lanes is 16", [](RenderSettings& s) {
    s.lanes = 16;
    s.bvh_width = 4;
  });
  refused("passes is 0", [](RenderSettings& s) { s.passes = 0; });
  for (const Aov aov : {Aov::xyz, Aov::xyz_squared})
    refused("has a layer only by a name", [&](RenderSettings& s) { s.aovs = {aov, Aov::depth}; });
  refused("has 251 bytes; a file holds 250", [](RenderSettings& s) {
    s.aovs.add(NamedAov{std::string(251, 'a'), Aov::uv});
  });
  refused("\"a\" and \"a\" have the channel a.X in common", [](RenderSettings& s) {
    s.aovs.add(NamedAov{"a", Aov::uv});
    s.aovs.add(NamedAov{"a", Aov::position});
    s.aovs.add(NamedAov{"b", Aov::xyz});
    s.aovs.add(NamedAov{"a", Aov::normal});
  });
}

TEST_CASE("a renderer makes one picture at a time") {
  Renderer renderer(Device::open("pocl"), small_scene(scene_folder / "lecture/lit.xml", 16, 16, 8), {});
  const RenderResult expected = renderer.render();
  int refused = 0;
  const RenderResult result = renderer.render([&](const Progress&) {
    CHECK_THROWS_AS(renderer.render(), UsageError);
    ++refused;
    return true;
  });
  CHECK(refused > 0);
  CHECK(same_bits(result.color, expected.color));
  CHECK_THROWS_AS(renderer.render([](const Progress&) -> bool { throw 1; }), int);
  CHECK(same_bits(renderer.render().color, expected.color));
}

TEST_CASE("rays are traced once or more often") {
  Intersector intersector(pocl(), lit_sphere());
  const std::vector<Ray> rays{{{0, 0, 0}, {0, 0, 1}}};
  for (const int repeat : {0, -1}) CHECK_THROWS_AS(intersector.trace(rays, false, repeat), UsageError);
  CHECK(intersector.trace(rays, false, 2)[0].t == Approx(4));
  CHECK(intersector.stats().kernel_runs.size() == 2);
}

TEST_CASE("goals that cannot be reached are refused") {
  const Device device = pocl();
  Renderer renderer(device, lit_sphere());
  const auto refused = [](Renderer& by, const RenderGoal& goal) { CHECK_THROWS_AS(by.render({}, goal), UsageError); };
  RenderGoal goal;
  for (const double error : {std::numeric_limits<double>::quiet_NaN(), -0.1, 0.0}) {
    INFO(error);
    goal.max_error = error;
    refused(renderer, goal);
  }
  RenderSettings untold;
  untold.estimate_error = false;
  Renderer without(device, lit_sphere(), untold);
  goal.max_error = 0.5;
  goal.spp = 64;  // Else this test would take minutes where it fails.
  refused(without, goal);
  CHECK(renderer.render({}, goal).complete);

  goal = {};
  goal.deadline = later(Clock::now(), 60);
  goal.spp = 1;
  RenderSettings traced_again;
  traced_again.aovs = {Aov::numeric_error};
  Renderer again(device, lit_sphere(), traced_again);
  refused(again, goal);
  CHECK_THROWS_WITH(again.render({}, goal), Contains("numeric_error traces the scene once more"));
  goal.is_pilot = true;
  CHECK(again.render({}, goal).complete);

  goal = {};
  constexpr int most = std::numeric_limits<int>::max();
  for (const Rows rows : {Rows{1, most}, Rows{-1, 2}, Rows{most, most}, Rows{8, 1}, Rows{0, 0}}) {
    INFO(rows.first << " " << rows.count);
    goal.rows = rows;
    refused(renderer, goal);
  }
  goal.rows.reset();
  goal.samples = SampleRange{1, most};
  CHECK_THROWS_WITH(renderer.render({}, goal), Contains("samples 1:2147483648 are not among"));
  goal.samples.reset();
  goal.rows = Rows{1, 7};
  CHECK(renderer.render({}, goal).color.height == 7);
}

}  // namespace strahl::test
