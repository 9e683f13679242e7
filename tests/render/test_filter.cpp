// SPDX-License-Identifier: MIT
// Where samples are drawn: what a lamp's straight edge leaves in the pixels beside it is the filter's tail, however
// little that is, drawn from or shared among pixels; one ray through a pixel's middle goes through the lens's middle. 2
// s.
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>

#include "kinds/filter_density.h"
#include "render/stage.h"
#include "scene/model/build.h"

namespace strahl::test {
namespace {

constexpr double pixel = 2 * half_width / stage_size;
constexpr int samples = 16384;

/// Of the gaussian, lowered so that it ends in 0 at the radius: the share beyond x pixels, on one side.
double tail(double x, double radius, double stddev) {
  const double unit = stddev * std::sqrt(2.0), floor = std::exp(-radius * radius / (unit * unit));
  const auto beyond = [&](double from) {
    return 0.5 * std::sqrt(std::acos(-1.0)) * unit * (std::erfc(from / unit) - std::erfc(radius / unit)) -
           floor * (radius - from);
  };
  return x < radius ? beyond(x) / (2 * beyond(0)) : 0;
}

/// The share of a filter's integral beyond x pixels, on one side; by the midpoint rule.
double share_beyond(const Filter& filter, double x) {
  constexpr int steps = 20000;
  const double radius = kinds::filter_radius(filter);
  double beyond = 0, half = 0;
  for (int i = 0; i < steps; ++i) {
    const double at = (i + 0.5) / steps * radius, density = kinds::filter_density(filter, at);
    half += density;
    if (at > x) beyond += density;
  }
  return beyond / (2 * half);
}

/// A lamp that ends `edge` pixels right of the picture's middle, and four columns from there on.
Scene lamp_edge(const Filter& filter, double edge) {
  Scene scene = stage({});
  add(scene, emitting(Rectangle{{edge * pixel - 9, -9, 0}, {9, 0, 0}, {0, 18, 0}}, {1, 1, 1}));
  scene.integrator.name = "emission";
  scene.sampler.kind = SamplerKind::independent;
  scene.sampler.sample_count = samples;
  scene.film.filter = filter;
  scene.film.crop = Window{stage_size / 2, 0, stage_size / 2 + 4, stage_size};
  return scene;
}

void hold(const Filter& filter, const std::function<double(double)>& share, double edge) {
  const Scene scene = lamp_edge(filter, edge);
  RenderSettings settings;
  settings.disabled = without_sharing;
  for (const Image& image : {color(scene, Precision::robust), render("pocl", scene, settings).color})
    for (int x = 0; x < image.width; ++x) {
      double lit = 0;
      for (int y = 0; y < image.height; ++y) lit += samples * static_cast<double>(image.at(x, y, 0));
      const double distance = x + 0.5 - edge, expected = samples * image.height * share(distance);
      INFO(distance << " pixels off");
      CHECK(std::fabs(lit - expected) < 5 * std::sqrt(expected) + 3);
    }
}

}  // namespace

TEST_CASE("a lamp's edge shows the filter's tail") {
  require_pocl();
  for (const double edge : {0.0, -0.25, -0.5}) {
    for (const double radius : {2.0, 3.0, 30.0})
      hold(
          {FilterKind::gaussian, radius, 0.5}, [&](double x) { return tail(x, radius, 0.5); }, edge);
    hold(
        {FilterKind::tent, 1, 0.5}, [](double x) { return x < 1 ? (1 - x) * (1 - x) / 2 : 0; }, edge);
    hold(
        {FilterKind::box, 1.2, 0.5}, [](double x) { return x < 1.2 ? (1.2 - x) / 2.4 : 0; }, edge);
  }
}

TEST_CASE("filters with negative parts are below 0 beside a lamp") {
  require_pocl();
  const Filter filters[] = {{FilterKind::mitchell}, {FilterKind::catmullrom}, {FilterKind::lanczos}};
  for (const Filter& filter : filters)
    for (const double edge : {0.0, -0.25}) {
      const Image image = color(lamp_edge(filter, edge), Precision::robust);
      for (int x = 0; x < image.width; ++x) {
        double lit = 0;
        for (int y = 0; y < image.height; ++y) lit += static_cast<double>(image.at(x, y, 0)) / image.height;
        const double distance = x + 0.5 - edge;
        CAPTURE(static_cast<int>(filter.kind), distance);
        CHECK(lit == Approx(share_beyond(filter, distance)).margin(8e-4));
      }
    }
}

TEST_CASE("by default depth is seen through the middle of a lens") {
  require_pocl();
  Scene scene;
  scene.materials = {Material{}};
  add(scene, Sphere{{0, 0, 0}, 1});
  scene.camera = perspective_camera({0, -6, 2}, {0, 0, 0}, {0, 0, 1}, 40);
  scene.camera.aperture_radius = 0.5;
  scene.camera.focus_distance = 2;
  scene.film.width = scene.film.height = 32;
  scene.integrator.name = "depth";
  const Image found = color(scene);
  scene.camera.aperture_radius = 0;
  CHECK(lit_pixels(found) > 100);
  CHECK(found.data == color(scene).data);
}

}  // namespace strahl::test
