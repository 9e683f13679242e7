// SPDX-License-Identifier: MIT
// What media scatter, against answers that were found another way: the integral of what is scattered once, the H
// function of a half space, and walks of light in double precision on the host, with numbers and formulas of their own.
// STRAHL_SCATTERING=long: more samples, and bounds as close as they then allow. 15 s.
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <random>
#include <string_view>
#include <vector>

#include "render/filled.h"
#include "scene/model/build.h"

namespace strahl::test {
namespace {

using std::numbers::pi;

bool takes_long() {
  const char* run = std::getenv("STRAHL_SCATTERING");
  return run != nullptr && std::string_view(run) == "long";
}

/// How many times as many samples the long run takes.
int more() { return takes_long() ? 64 : 1; }

/// Chandrasekhar's H(mu) of isotropic scattering. 1 / H(mu) = sqrt(1 - albedo) + albedo / 2 integral of
/// m H(m) / (mu + m) over m in (0, 1): S. Chandrasekhar, "Radiative Transfer", 1950, V.
double h_function(double albedo, double mu) {
  constexpr int n = 400;
  std::vector<double> m(n), h(n, 1), next(n);
  for (int i = 0; i < n; ++i) m[static_cast<std::size_t>(i)] = (i + 0.5) / n;
  const auto value = [&](double at) {
    double sum = 0;
    for (std::size_t k = 0; k < n; ++k) sum += m[k] * h[k] / (at + m[k]);
    return 1 / (std::sqrt(1 - albedo) + 0.5 * albedo * sum / n);
  };
  for (int turn = 0; turn < 200; ++turn) {
    for (std::size_t i = 0; i < n; ++i) next[i] = value(m[i]);
    h = next;
  }
  return value(mu);
}

/// Light of a point at `height` beside the line of sight that is scattered there once, `before` the point's foot on:
/// with s = height tan(angle) along the line 1 / r^2 ds is dangle / height.
double scattered_once(double sigma_t, double albedo, double g, double height, double before) {
  constexpr int n = 4000;
  const double first = std::atan2(-before, height), step = (pi / 2 - first) / n;
  double sum = 0;
  for (int i = 0; i < n; ++i) {
    const double angle = first + (i + 0.5) * step, s = height * std::tan(angle), r = height / std::cos(angle);
    // Light runs from the lamp to the place, and from there back along the line.
    const double cosine = -s / r;
    const double phase = (1 - g * g) / (4 * pi * std::pow(1 + g * g - 2 * g * cosine, 1.5));
    sum += phase * std::exp(-sigma_t * (s + before + r));
  }
  return albedo * sigma_t * sum * step / height;
}

TEST_CASE("light of a point that a medium scatters once is its integral along the ray") {
  require_pocl();
  for (const double g : {0.0, 0.6, -0.4}) {
    Medium air = medium({0.15, 0.3, 0.6}, {0.9, 0.8, 0.7});
    air.phases = {{PhaseFunction::Kind::hg, 1, g}};
    Scene scene = stage({}, {});
    scene.media = {air};
    scene.camera.world_from_camera.m = {{{-1e-3, 0, 0, 0}, {0, 1e-3, 0, 0}, {0, 0, -1, 4}}};
    scene.camera.medium = 0;
    scene.integrator.name = "volpath";
    scene.integrator.max_depth = 2;
    scene.lights = {light(PointLight{{1.5, 0, 0}, {1, 1, 1}})};
    const Rgb mean = mean_of(drawn(scene, 64 * more()));
    const double bound = takes_long() ? 0.002 : 0.01;
    INFO(g);
    CHECK(mean.r == Approx(scattered_once(0.15, 0.9, g, 1.5, 4)).epsilon(bound));
    CHECK(mean.g == Approx(scattered_once(0.3, 0.8, g, 1.5, 4)).epsilon(bound));
    CHECK(mean.b == Approx(scattered_once(0.6, 0.7, g, 1.5, 4)).epsilon(bound));
  }
}

TEST_CASE("a half space reflects as its H function says") {
  require_pocl();
  // Of white surroundings it sends 1 - sqrt(1 - albedo) H(1) straight up. 200 mean free paths are a half space.
  Scene scene = filled(slab(1), medium({200, 200, 200}, {0.5, 0.9, 0.98}));
  scene.sampler.kind = SamplerKind::sobol;
  scene.sampler.sample_count = 64 * more();
  const Rgb mean = mean_of(color(scene, Precision::robust));
  const double bound = takes_long() ? 0.001 : 0.004;
  CHECK(mean.r == Approx(1 - std::sqrt(0.5) * h_function(0.5, 1)).epsilon(bound));
  CHECK(mean.g == Approx(1 - std::sqrt(0.1) * h_function(0.9, 1)).epsilon(bound));
  CHECK(mean.b == Approx(1 - std::sqrt(0.02) * h_function(0.98, 1)).epsilon(bound));
}

/// Fresnel's reflectance of unpolarised light within glass of index `eta`, which meets the surface at `cosine`.
double reflected_within(double eta, double cosine) {
  const double sine2 = eta * eta * (1 - cosine * cosine);
  if (sine2 >= 1) return 1;
  const double beyond = std::sqrt(1 - sine2);
  const double s = (eta * cosine - beyond) / (eta * cosine + beyond);
  const double p = (cosine - eta * beyond) / (cosine + eta * beyond);
  return 0.5 * (s * s + p * p);
}

/// How much of a thin beam, straight down into a slab `depth` mean free paths deep, comes out again nearer than each of
/// `radii` to where it went in, for three albedos. eta: of glass with a smooth surface; 1: there is none.
std::vector<std::array<double, 3>> spread_of_beam(const std::vector<double>& radii, const std::array<double, 3>& albedo,
                                                  double g, double eta, double depth, int walks) {
  std::mt19937_64 random(2026);
  std::uniform_real_distribution<double> number(0, 1);
  std::vector<std::array<double, 3>> sums(radii.size(), {0, 0, 0});
  const auto arrive = [&](double x, double y, const std::array<double, 3>& weight) {
    for (std::size_t k = 0; k < radii.size(); ++k)
      if (std::hypot(x, y) < radii[k])
        for (std::size_t c = 0; c < 3; ++c) sums[k][c] += weight[c] / walks;
  };
  const double straight_back = (eta - 1) * (eta - 1) / ((eta + 1) * (eta + 1));
  for (int walk = 0; walk < walks; ++walk) {
    std::array<double, 3> weight{1 - straight_back, 1 - straight_back, 1 - straight_back};
    double x = 0, y = 0, z = 0, dx = 0, dy = 0, dz = 1;  // z downwards.
    double left = -std::log(1 - number(random));
    while (weight[2] > 1e-6) {
      const double to_side = dz > 0 ? (depth - z) / dz : dz < 0 ? -z / dz : 1e300;
      if (left >= to_side) {
        x += to_side * dx;
        y += to_side * dy;
        z = dz > 0 ? depth : 0;
        left -= to_side;
        if (number(random) >= reflected_within(eta, std::abs(dz))) {
          if (dz < 0) arrive(x, y, weight);
          break;
        }
        dz = -dz;
        continue;
      }
      x += left * dx;
      y += left * dy;
      z += left * dz;
      left = -std::log(1 - number(random));
      for (std::size_t c = 0; c < 3; ++c) weight[c] *= albedo[c];
      // Henyey and Greenstein's cosine by its inverse, about the direction so far.
      const double u = number(random), around = 2 * pi * number(random);
      const double bend = g == 0 ? 0 : (1 - g * g) / (1 - g + 2 * g * u);
      const double cosine = g == 0 ? 2 * u - 1 : (1 + g * g - bend * bend) / (2 * g);
      const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine)), a = std::cos(around), b = std::sin(around);
      const double flat = std::hypot(dx, dy);
      if (flat < 1e-9) {
        dx = sine * a;
        dy = sine * b;
        dz = dz > 0 ? cosine : -cosine;
      } else {
        const double nx = dx * cosine + sine * (dx * dz * a - dy * b) / flat;
        const double ny = dy * cosine + sine * (dy * dz * a + dx * b) / flat;
        dz = dz * cosine - sine * flat * a;
        dx = nx;
        dy = ny;
      }
    }
  }
  for (auto& sum : sums)
    for (double& share : sum) share += straight_back;
  return sums;
}

TEST_CASE("a beam comes out around where it went in as walks on the host have it") {
  require_pocl();
  const std::vector<double> radii{0.5, 2, 5};
  const std::array<double, 3> albedo{0.6, 0.9, 0.98};
  constexpr double density = 20, g = 0.3;
  Medium flesh = medium({density, density, density}, {albedo[0], albedo[1], albedo[2]});
  flesh.phases = {{PhaseFunction::Kind::hg, 1, g}};
  for (const double eta : {1.0, 1.4}) {
    Scene scene = filled(slab(1), flesh, 0);
    scene.lights.clear();
    if (eta != 1) {
      scene.materials.front() = Material{};
      scene.materials.front().bsdf = Dielectric{eta, 1};
    }
    // Seen the other way round: a beam of camera rays, and what it finds of a shining disk close over the surface.
    scene.camera.world_from_camera.m = {{{-1e-5, 0, 0, 0}, {0, 1e-5, 0, 0}, {0, 0, -1, 0.5001}}};
    const auto expected = spread_of_beam(radii, albedo, g, eta, density, 200000 * (takes_long() ? 32 : 1));
    for (std::size_t k = 0; k < radii.size(); ++k) {
      const double r = radii[k] / density;
      Scene lit = scene;
      add(lit, Disk{{0, 0, 0.5002}, {r, 0, 0}, {0, -r, 0}}, add(lit, Diffuse{{{0, 0, 0}}}));
      lit.shapes.back().radiance = Rgb{1, 1, 1};
      const Rgb mean = mean_of(drawn(lit, 32 * more()));
      const double bound = takes_long() ? 0.0015 : 0.006;
      INFO("index " << eta << ", radius " << radii[k]);
      CHECK(mean.r == Approx(expected[k][0]).margin(bound));
      CHECK(mean.g == Approx(expected[k][1]).margin(bound));
      CHECK(mean.b == Approx(expected[k][2]).margin(bound));
    }
  }
}

}  // namespace
}  // namespace strahl::test
