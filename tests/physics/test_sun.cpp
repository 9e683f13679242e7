// SPDX-License-Identifier: MIT
// A sun before a background, by every integrator that shows light: irradiance in closed form, the disc in a mirror, and
// what is seen of it beside the sky.
#include "physics/transport_scenes.h"

using namespace strahl;
using namespace strahl::test;

namespace {

constexpr double aperture = 12;  // Degrees.

Scene under_sun(const decltype(Material::bsdf)& bsdf, const Vec3& sun) {
  Scene scene = empty_scene();
  scene.materials.front().bsdf = bsdf;
  scene.shapes.emplace_back().geometry = Rectangle{{-1, -1, 0}, {2, 0, 0}, {0, 2, 0}};
  scene.lights.emplace_back().emitter = ConstantLight{{1, 1, 1}};
  scene.lights.emplace_back().emitter = SunLight{sun, aperture, {40, 20, 10}};
  return scene;
}

void hold(const Scene& scene, const TransportTier& tier, const GivenRay& ray, const Triad& expected) {
  std::array<std::vector<double>, 3> values;
  for (const Triad& one : tier.radiance(TierScene(scene, tier).buffers(), ray, 4096))
    for (std::size_t k = 0; k < 3; ++k) values[k].push_back(one[k]);
  for (std::size_t k = 0; k < 3; ++k) {
    const Mean mean = mean_of(values[k]);
    CHECK(mean.value == Approx(expected[k]).epsilon(0).margin(5 * mean.noise + 2000 * roundoff(tier)));
    CHECK(mean.noise < 0.05 * expected[k]);
  }
}

TEST_CASE("a matt surface has the irradiance of sky and sun, a mirror shows both") {
  const Vec3 sun = normalized({0.5, 0.2, 0.9});
  // Of a whole disc above the horizon: pi sin^2 of half its opening, times the cosine of its middle.
  const double sine = std::sin(aperture * std::numbers::pi / 360);
  const double share = sine * sine * sun.z;
  const GivenRay ray{{0, 0, 1}, {0, 0, -1}, 0, 1e30};
  for (const char* integrator : {"path", "direct", "whitted"})
    for (const TransportTier& tier : transport_tiers()) {
      INFO(tier.name << ", " << tier.lanes << " lanes, " << integrator);
      Scene matt = under_sun(Diffuse{{{0.5, 0.5, 0.5}}}, sun);
      matt.integrator.name = integrator;
      hold(matt, tier, ray, {0.5 * (1 + 40 * share), 0.5 * (1 + 20 * share), 0.5 * (1 + 10 * share)});
      if (std::string(integrator) == "direct") continue;
      Scene mirror = under_sun(Conductor{}, {0, 0.05, 1});
      mirror.integrator.name = integrator;
      hold(mirror, tier, ray, {41, 21, 11});
      mirror = under_sun(Conductor{}, {0, 0.2, 1});
      mirror.integrator.name = integrator;
      hold(mirror, tier, ray, {1, 1, 1});
    }
}

TEST_CASE("the horizon cuts the disc") {
  const double sine = std::sin(aperture * std::numbers::pi / 360), share = sine * sine / 2;
  for (const char* integrator : {"path", "whitted"})
    for (const TransportTier& tier : transport_tiers()) {
      INFO(tier.name << ", " << tier.lanes << " lanes, " << integrator);
      Scene matt = under_sun(Diffuse{{{0.5, 0.5, 0.5}}}, {0, 0, 2});
      std::get<SunLight>(matt.lights.back().emitter).up = {3, 0, 0};
      matt.integrator.name = integrator;
      hold(matt, tier, {{0, 0, 1}, {0, 0, -1}, 0, 1e30},
           {0.5 * (1 + 40 * share), 0.5 * (1 + 20 * share), 0.5 * (1 + 10 * share)});
      Scene mirror = under_sun(Conductor{}, {0, 0, 2});
      mirror.lights.back() = matt.lights.back();
      mirror.integrator.name = integrator;
      hold(mirror, tier, {{0, 0, 1}, {0.02, 0, -1}, 0, 1e30}, {41, 21, 11});
      hold(mirror, tier, {{0, 0, 1}, {-0.02, 0, -1}, 0, 1e30}, {1, 1, 1});
    }
}

TEST_CASE("rays that leave the scene see the disc before the sky, unless it is hidden") {
  const Vec3 sun = normalized({0.5, 0.2, 0.9});
  Scene scene = under_sun(Diffuse{}, sun);
  const GivenRay at_sun{{0, 0, 5}, triad(sun), 0, 1e30}, beside{{0, 0, 5}, {0.5, -0.2, 0.9}, 0, 1e30};
  for (const char* integrator : {"path", "direct", "whitted", "emission"})
    for (const TransportTier& tier : transport_tiers()) {
      INFO(tier.name << ", " << tier.lanes << " lanes, " << integrator);
      scene.integrator.name = integrator;
      scene.integrator.hide_emitters = false;
      hold(scene, tier, at_sun, {41, 21, 11});
      hold(scene, tier, beside, {1, 1, 1});
      scene.integrator.hide_emitters = true;
      for (const Triad& one : tier.radiance(TierScene(scene, tier).buffers(), at_sun, 16)) CHECK(one == Triad{0, 0, 0});
    }
}

}  // namespace
