// SPDX-License-Identifier: MIT
// A floor under many lamps, points and spots, against its closed form, by every way to choose among them: none is
// biased. Power alone gains nothing where weak lamps stand close to the floor.
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "render/filled.h"

namespace strahl::test {
namespace {

constexpr double floor_albedo = 0.6;

double falloff(const SpotLight& spot, const Vec3& way) {
  const double degrees = 180 / std::numbers::pi * std::acos(dot(normalized(spot.axis), normalized(way)));
  return std::clamp((spot.cutoff_degrees - degrees) / (spot.cutoff_degrees - spot.beam_degrees), 0.0, 1.0);
}

/// Radiance of the floor in units of a lamp's colour.
double light_of_lamps(const Scene& scene, const Vec3& at) {
  double sum = 0;
  for (const Light& light : scene.lights) {
    const auto* spot = std::get_if<SpotLight>(&light.emitter);
    const Vec3 from = spot != nullptr ? spot->position : std::get<PointLight>(light.emitter).position;
    const double intensity = spot != nullptr ? spot->intensity.r : std::get<PointLight>(light.emitter).intensity.r;
    const Vec3 way = at - from;
    const double d = length(way);
    sum += intensity * (spot != nullptr ? falloff(*spot, way) : 1) * from.z / (d * d * d);
  }
  return floor_albedo / std::numbers::pi * sum;
}

Scene under_lamps() {
  Scene scene = stage({floor_plane()}, diffuse({floor_albedo, floor_albedo, floor_albedo}));
  std::mt19937 engine(5);
  std::uniform_real_distribution<double> unit(0, 1);
  const auto within = [&](double least, double most) { return least + (most - least) * unit(engine); };
  for (int i = 0; i < 40; ++i) {
    const Vec3 at{within(-2, 2), within(-2, 2), within(0.1, 0.6)};
    const double power = std::pow(10, within(-2, 0));
    if (i % 2 == 0)
      scene.lights.push_back(light(PointLight{at, {power, power, power}}));
    else
      scene.lights.push_back(light(SpotLight{at, {within(-1, 1), within(-1, 1), -1}, {power, power, power}, 50, 20}));
  }
  scene.film.filter = {FilterKind::box, 1e-9};
  scene.integrator.name = "path";
  scene.integrator.max_depth = 2;
  scene.sampler.kind = SamplerKind::independent;
  scene.sampler.sample_count = 64;
  return scene;
}

TEST_CASE("every way to choose among lamps has the same mean, and less noise the more is asked") {
  require_pocl();
  const Scene scene = under_lamps();
  const Device device = Device::open("pocl");
  double least = INFINITY;
  for (const char* choice : {"uniform", "power", "tree", "each"}) {
    RenderSettings settings = generic_settings();
    settings.light_choice = choice;
    const Image image = Renderer(device, scene, settings).render().color;
    double sum = 0, squares = 0, light = 0;
    constexpr double count = stage_size * stage_size;
    for (int y = 0; y < stage_size; ++y)
      for (int x = 0; x < stage_size; ++x) {
        const double truth = light_of_lamps(scene, {stage_x(x), stage_y(y), 0});
        const double off = static_cast<double>(image.at(x, y, 0)) - truth;
        sum += off;
        squares += off * off;
        light += truth;
      }
    INFO(choice << ": rmse " << std::sqrt(squares / count) << " of a mean of " << light / count << ", " << sum / count
                << " above it");
    CHECK(std::fabs(sum) < 4 * std::sqrt(squares));
    if (std::string(choice) == "tree") CHECK(squares < 0.3 * least);
    if (std::string(choice) == "each") CHECK(squares < least);
    least = std::min(least, squares);
  }
}

/// docs/scene-emitters.md: found by rays that hit it alone.
TEST_CASE("lights of sampling_weight 0 are drawn by nothing") {
  require_pocl();
  const auto mean = [](const Scene& scene, const char* choice) {
    RenderSettings settings;
    settings.precision = Precision::stable;
    if (choice != nullptr) settings.light_choice = choice;
    return static_cast<double>(mean_of(render("pocl", scene, settings).color).g);
  };
  Scene lamp = stage({floor_plane()}, diffuse({1, 1, 1}));
  lamp.integrator.name = "path";
  lamp.integrator.max_depth = 2;
  lamp.sampler.kind = SamplerKind::independent;
  lamp.sampler.sample_count = 64;
  const auto at = [](double x, double weight) {
    Light made = light(PointLight{{x, 0, 1}, {1, 1, 1}});
    made.sampling_weight = weight;
    return made;
  };
  lamp.lights = {at(0, 0)};
  CHECK(mean(lamp, nullptr) == 0);
  lamp.lights = {at(1, 1)};
  const double one = mean(lamp, nullptr);
  for (const char* choice : {"uniform", "power", "tree", "each"}) {
    INFO(choice);
    lamp.lights = {at(0, 0), at(1, 1)};
    CHECK(mean(lamp, choice) == Approx(one).epsilon(1e-6));
    lamp.lights = {at(0, 0), at(0.5, 0)};
    CHECK(mean(lamp, choice) == 0);
  }
  lamp.integrator.name = "direct";
  lamp.lights = {at(1, 0)};
  CHECK(mean(lamp, nullptr) == Approx(one).epsilon(1e-3));  // Takes all.
  // A panel over all of the floor is found by every ray that the floor sends up.
  Scene panel = lamp;
  panel.lights.clear();
  panel.integrator.name = "path";
  panel.shapes.emplace_back();
  panel.shapes.back().geometry = Rectangle{{-1e3, -1e3, 5}, {0, 2e3, 0}, {2e3, 0, 0}};
  panel.shapes.back().radiance = Rgb{1, 1, 1};
  panel.integrator.hide_emitters = true;
  for (const double weight : {0.0, 1.0}) {
    INFO(weight);
    panel.shapes.back().sampling_weight = weight;
    CHECK(mean(panel, nullptr) == Approx(1).epsilon(0.02));
  }
}

/// A floor that is lit about alike by a light from afar and by two lamps. These are so high above it that one over what
/// they bring with least weight overflows.
TEST_CASE("lights of hardly any weight are drawn, and take nothing from others") {
  require_pocl();
  const auto mean = [](double far, double near, const char* choice) {
    Scene scene = stage({floor_plane()}, diffuse({1, 1, 1}));
    scene.integrator.name = "path";
    scene.integrator.max_depth = 2;
    scene.sampler.kind = SamplerKind::independent;
    scene.sampler.sample_count = 64;
    scene.lights = {light(DirectionalLight{{0, 0, -1}, {1, 1, 1}}), light(PointLight{{1, 0, 1e5}, {1e10, 1e10, 1e10}}),
                    light(PointLight{{-1, 0, 1e5}, {1e10, 1e10, 1e10}})};
    scene.lights[0].sampling_weight = far;
    scene.lights[1].sampling_weight = scene.lights[2].sampling_weight = near;
    RenderSettings settings = generic_settings();
    settings.light_choice = choice;
    return static_cast<double>(mean_of(render("pocl", scene, settings).color).g);
  };
  for (const char* choice : {"power", "tree", "each"})
    for (const auto& [far, near] : {std::pair{1e-40, 1.0}, std::pair{1e-300, 1.0}, std::pair{1.0, 1e-40}}) {
      INFO(choice << ", weights " << far << " and " << near);
      CHECK(mean(far, near, choice) == Approx(3 / std::numbers::pi).epsilon(0.02));
    }
}

TEST_CASE("an emitting part without area changes nothing") {
  require_pocl();
  Scene scene = stage({floor_plane()}, diffuse({1, 1, 1}));
  Mesh mesh;
  mesh.positions = {{-1, -1, 1}, {-1, 1, 1}, {1, 1, 1}, {1, -1, 1}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 0, 1}};
  mesh.parts = {{0, Rgb{1, 1, 1}}, {0, Rgb{9, 9, 9}}};
  mesh.part_of_triangle = {0, 0, 1};
  scene.shapes.emplace_back().geometry = mesh;
  scene.integrator.name = "path";
  scene.integrator.max_depth = 2;
  scene.sampler.kind = SamplerKind::independent;
  scene.sampler.sample_count = 16;
  RenderSettings settings;
  settings.light_choice = "power";  // Of which there are no tables where one light is left.
  const Image with = render("pocl", scene, settings).color;
  auto& plain = std::get<Mesh>(scene.shapes.back().geometry);
  plain.triangles.pop_back();
  plain.part_of_triangle.clear();
  plain.parts.clear();
  scene.shapes.back().radiance = Rgb{1, 1, 1};
  CHECK(with.data == render("pocl", scene, settings).color.data);
}

}  // namespace
}  // namespace strahl::test
