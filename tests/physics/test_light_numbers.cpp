// SPDX-License-Identifier: MIT
// The light, its item and the place on it are chosen by three numbers. With a hundred lights, one of them a mesh of 1e5
// triangles, each number is uniform to its last bits and independent of the others. 3 s.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <utility>
#include <vector>

#include "packing/pack.h"
#include "physics/light_tiers.h"

using namespace strahl;
using namespace strahl::test;

namespace {

constexpr int lights = 100, items = 100000;

Shape emitting(const Geometry& geometry) {
  Shape shape;
  shape.geometry = geometry;
  shape.radiance = Rgb{1, 1, 1};
  return shape;
}

/// Small spheres, and between them a mesh that repeats one triangle, so that a place determines its numbers.
Scene many_lights(SamplerKind sampler) {
  Scene scene;
  scene.materials.emplace_back();
  scene.integrator.name = "path";
  scene.sampler.kind = sampler;
  scene.sampler.sample_count = 16;
  for (int i = 0; i < lights; ++i) scene.shapes.push_back(emitting(Sphere{{10.0 + i, 0, 0}, 0.1}));
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles.assign(items, {0, 1, 2});
  scene.shapes[lights / 2] = emitting(mesh);
  return scene;
}

/// Chi^2 per degree of freedom of counts that should be equal.
double chi_square(const std::vector<int>& counts) {
  double total = 0, sum = 0;
  for (const int n : counts) total += n;
  const double expected = total / static_cast<double>(counts.size());
  for (const int n : counts) sum += (n - expected) * (n - expected) / expected;
  return sum / static_cast<double>(counts.size() - 1);
}

/// Within five standard deviations of 1, where the bins hold more than a few each.
void hold_uniform(const std::string& what, const std::vector<int>& counts) {
  INFO(what);
  CHECK(std::fabs(chi_square(counts) - 1) < 5 * std::sqrt(2.0 / static_cast<double>(counts.size() - 1)));
}

struct Draw {
  int item;
  double u, v;
};

/// The square's point that cl/math/sampling_lanes.h maps to that place of the triangle.
Draw draw_at(int item, double x, double y) { return {item, x < y ? 2 * x : x + y, x < y ? x + y : 2 * y}; }

template <class Real>
std::vector<Draw> draws_on_mesh(const Scene& scene, std::uint32_t samples, std::vector<int>& of_light) {
  RenderSettings settings;
  settings.generic = true;
  settings.light_choice = "uniform";
  const PackedScene<Real> packed = pack_scene<Real>(scene, features_of(scene, settings), {1, UploadFrame{}, 0});
  const HostBuffers<Real> buffers{packed.geometry.data(), packed.shading.data(), packed.index.data()};
  std::vector<Draw> draws;
  for (std::uint32_t i = 0; i < samples; ++i) {
    const auto drawn = drawn_light(buffers, i, 1, {Real(0.3), Real(0.2), Real(2)});
    ++of_light.at(static_cast<std::size_t>(drawn.light));
    if (drawn.light != lights / 2) continue;
    const double x = static_cast<double>(drawn.towards[0]) + 0.3, y = static_cast<double>(drawn.towards[1]) + 0.2;
    draws.push_back(draw_at(drawn.id - lights / 2, x, y));
  }
  return draws;
}

/// Counts pairs of draws of the same item whose u agree to 2^-16. If one number chose all three, only some 8 bits would
/// be left for u.
int same_places(std::vector<Draw> draws) {
  std::sort(draws.begin(), draws.end(),
            [](const Draw& a, const Draw& b) { return std::pair(a.item, a.u) < std::pair(b.item, b.u); });
  int same = 0;
  for (std::size_t i = 1; i < draws.size(); ++i)
    same += draws[i].item == draws[i - 1].item && draws[i].u - draws[i - 1].u < std::ldexp(1.0, -16);
  return same;
}

std::size_t bin(double x, int bins) {
  return static_cast<std::size_t>(std::clamp(static_cast<int>(x * bins), 0, bins - 1));
}

template <class Real>
void hold(SamplerKind sampler) {
  std::vector<int> of_light(lights, 0);
  const std::vector<Draw> draws = draws_on_mesh<Real>(many_lights(sampler), 1u << 22, of_light);
  // For sobol only an upper bound: its points are more even than random ones.
  const bool is_random = sampler == SamplerKind::independent;
  constexpr int fine = 64, coarse = 8;
  std::vector<int> item(1000), u_digits(fine), v_digits(fine), item_u(coarse * coarse), item_v(coarse * coarse);
  for (const auto& [at, u, v] : draws) {
    const double share = (at + 0.5) / items;
    ++item.at(bin(share, 1000));
    // Digits 13 to 18 of the number: fp32 has 23.
    ++u_digits.at(bin(std::ldexp(u, 12) - std::floor(std::ldexp(u, 12)), fine));
    ++v_digits.at(bin(std::ldexp(v, 12) - std::floor(std::ldexp(v, 12)), fine));
    ++item_u.at(bin(share, coarse) * coarse + bin(u, coarse));
    ++item_v.at(bin(share, coarse) * coarse + bin(v, coarse));
  }
  // Some 9,000 pairs: 0.3 of them by chance.
  CHECK(same_places(draws) < 5);
  hold_uniform("u's last digits", u_digits);
  hold_uniform("v's last digits", v_digits);
  if (is_random) {
    hold_uniform("lights", of_light);
    hold_uniform("items", item);
  }
  hold_uniform("item and u", item_u);
  hold_uniform("item and v", item_v);
}

}  // namespace

TEMPLATE_TEST_CASE("the light, its item and the place have numbers of their own", "", float, double) {
  hold<TestType>(SamplerKind::independent);
  hold<TestType>(SamplerKind::sobol);
}
