// SPDX-License-Identifier: MIT
// A coat against the formula that Mitsuba 0.x has published, in long double: values, densities by quadrature, draws,
// both sides, grazing light; what a mirror under it shows by path and by whitted.
#include <map>

#include "kinds/materials.h"
#include "physics/transport_scenes.h"

using namespace strahl;
using namespace strahl::test;

namespace {

using Real = long double;

/// Of a smooth boundary: reflectance and the cosine behind it.
struct Boundary {
  Real reflectance, cosine;
};

Boundary boundary(Real c, Real eta) {
  const Real square = 1 - (1 - c * c) / (eta * eta);
  if (square <= 0) return {1, 0};
  const Real t = std::sqrt(square), s = (c - eta * t) / (c + eta * t), p = (eta * c - t) / (eta * c + t);
  return {(s * s + p * p) / 2, t};
}

Material with(const decltype(Material::bsdf)& bsdf) {
  Material material;
  material.bsdf = bsdf;
  return material;
}

/// Material 0 lies under the coat, which is material 1 and on the shape.
Scene coated(const decltype(Material::bsdf)& below, Coat coat) {
  Scene scene = empty_scene();
  coat.nested = 0;
  scene.materials = {with(below), with(coat)};
  Shape& shape = scene.shapes.emplace_back();
  shape.geometry = Rectangle{{-1, -1, 0}, {2, 0, 0}, {0, 2, 0}};
  shape.material = 1;
  return scene;
}

Coat amber() { return {1.6, 1.1, 0.5, {{0.2, 0.6, 1.4}}, {{0.9, 0.8, 0.7}}}; }
Coat thin() { return {1.0, 1.3, 2, {{0.1, 0, 0.3}}, {{1, 1, 1}}}; }

Triad direction(double cosine, double turn) {
  const double sine = std::sqrt((1 - cosine) * (1 + cosine)), angle = 2 * std::numbers::pi * turn;
  return {sine * std::cos(angle), sine * std::sin(angle), cosine};
}

Triad refracted(const Triad& w, Real eta) {
  const Real c = boundary(std::fabs(w[2]), eta).cosine;
  return {static_cast<double>(w[0] / eta), static_cast<double>(w[1] / eta), static_cast<double>(w[2] < 0 ? -c : c)};
}

/// exp(-sigma t (1/cos + 1/cos)) of both ways below, times what the boundary lets through.
std::array<Real, 3> left(const Coat& coat, const Triad& wo, const Triad& wi) {
  const Real eta = static_cast<Real>(coat.int_ior) / coat.ext_ior;
  const Boundary out = boundary(std::fabs(wo[2]), eta), in = boundary(std::fabs(wi[2]), eta);
  const Rgb& s = coat.sigma_a.color;
  std::array<Real, 3> all{};
  if (out.cosine <= 0 || in.cosine <= 0) return all;
  const Real slant = coat.thickness * (1 / out.cosine + 1 / in.cosine);
  for (std::size_t k = 0; k < 3; ++k)
    all[k] = (1 - out.reflectance) * (1 - in.reflectance) * std::exp(-std::array{s.r, s.g, s.b}[k] * slant);
  return all;
}

const std::vector<double> cosines = {1, 0.9, 0.4, 0.1, 1e-2, 1e-3, 1e-5, 1e-7};

TEST_CASE("light that goes down and up again is the published formula") {
  const auto below = {decltype(Material::bsdf)(Diffuse{{{0.8, 0.5, 0.3}}}), decltype(Material::bsdf)(Phong{}),
                      decltype(Material::bsdf)(
                          RoughConductor{.microfacets = {.alpha_u = {{0.3, 0.3, 0.3}}, .alpha_v = {{0.3, 0.3, 0.3}}}})};
  for (const auto& bsdf : below)
    for (const Coat& coat : {amber(), thin()})
      for (const TransportTier& tier : transport_tiers()) {
        INFO(tier.name << ", " << tier.lanes << " lanes, index " << coat.int_ior);
        const Real eta = static_cast<Real>(coat.int_ior) / coat.ext_ior;
        std::vector<SeenPlace> above, under;
        std::vector<Triad> wi, wi_under;
        for (const double out : cosines)
          for (const double in : cosines) {
            // Directions as the tier has them.
            const auto rounded = [](Triad t) {
              return Triad{static_cast<float>(t[0]), static_cast<float>(t[1]), static_cast<float>(t[2])};
            };
            above.push_back({0.5, 0.5, 0.5, rounded(direction(out, 0.1))});
            wi.push_back(rounded(direction(in, 0.55)));
            under.push_back({0.5, 0.5, 0.5, refracted(above.back().out, eta)});
            wi_under.push_back(refracted(wi.back(), eta));
          }
        Scene bare = coated(bsdf, coat);
        bare.shapes[0].material = 0;
        const std::vector<Triad> numbers(above.size(), {0.5, 0.5, 0.5});
        const std::vector<Lit> found = tier.lit(TierScene(coated(bsdf, coat), tier).buffers(), above, wi, numbers);
        const std::vector<Lit> nested = tier.lit(TierScene(bare, tier).buffers(), under, wi_under, numbers);
        for (std::size_t i = 0; i < found.size(); ++i) {
          INFO("cosines " << above[i].out[2] << " and " << wi[i][2]);
          const std::array<Real, 3> share = left(coat, above[i].out, wi[i]);
          for (std::size_t k = 0; k < 3; ++k) {
            const Real squeezed = share[k] == 0 ? 0 : wi[i][2] / (eta * eta * wi_under[i][2]);
            const double expected = static_cast<double>(share[k] * squeezed * nested[i].value[k]);
            // The nested value feels the rounding of directions below, by its slope.
            CHECK(found[i].value[k] == Approx(expected).epsilon(3000 * roundoff(tier)).margin(1e-30));
          }
        }
      }
}

/// Of a diffuse base: what is drawn from it and can leave is 1 / eta^2 of a cosine's hemisphere.
TEST_CASE("the density is that of the draws, and integrates to the share that leaves") {
  const Coat coat = amber();
  const double eta = coat.int_ior / coat.ext_ior;
  for (const TransportTier& tier : transport_tiers()) {
    const TierScene scene(coated(Diffuse{{{0.8, 0.5, 0.3}}}, coat), tier);
    for (const double cosine : {1.0, 0.5, 0.05}) {
      INFO(tier.name << ", " << tier.lanes << " lanes, cosine " << cosine);
      constexpr int steps = 2000, draws = 4000;
      std::vector<SeenPlace> places(steps, {0.5, 0.5, 0.5, direction(cosine, 0)});
      std::vector<Triad> wi, numbers(steps, {0.5, 0.5, 0.5});
      for (int i = 0; i < steps; ++i) wi.push_back(direction((i + 0.5) / steps, 0.3));
      double density = 0;
      std::array<double, 3> value{};
      for (const Lit& lit : tier.lit(scene.buffers(), places, wi, numbers)) {
        density += 2 * std::numbers::pi * lit.density / steps;
        for (std::size_t k = 0; k < 3; ++k) value[k] += 2 * std::numbers::pi * lit.value[k] / steps;
      }
      places.assign(draws, {0.5, 0.5, 0.5, direction(cosine, 0)});
      wi.assign(draws, {0, 0, 1});
      std::mt19937_64 engine(3);
      numbers.clear();
      for (int i = 0; i < draws; ++i) numbers.push_back({(i + 0.5) / draws, unit_number(engine), unit_number(engine)});
      const std::vector<Lit> drawn = tier.lit(scene.buffers(), places, wi, numbers);
      std::vector<SeenPlace> asked;
      std::vector<Triad> ways, unused;
      std::array<std::vector<double>, 3> weights;
      double mirrors = 0;
      for (const Lit& lit : drawn) {
        for (std::size_t k = 0; k < 3; ++k) weights[k].push_back(lit.weight[k]);
        if ((lit.lobe & lobes::LOBE_DELTA) != 0) {
          mirrors += 1.0 / draws;
          CHECK(lit.drawn[2] == Approx(cosine).epsilon(1e-5));
          continue;
        }
        asked.push_back({0.5, 0.5, 0.5, direction(cosine, 0)});
        ways.push_back(lit.weight[0] > 0 ? lit.drawn : Triad{0, 0, -1});
        unused.push_back({0.5, 0.5, 0.5});
      }
      const double reflected = static_cast<double>(boundary(cosine, eta).reflectance);
      const Rgb& tint = coat.specular_reflectance.color;
      CHECK(density == Approx((1 - mirrors) / (eta * eta)).epsilon(2e-3));
      for (std::size_t k = 0; k < 3; ++k) {
        const Mean mean = mean_of(weights[k]);
        const double all = value[k] + reflected * std::array{tint.r, tint.g, tint.b}[k];
        CHECK(mean.value == Approx(all).margin(5 * mean.noise + 1e-3));
        CHECK(all < 1);
      }
      // The weight is the value over the density of the very direction.
      const std::vector<Lit> again = tier.lit(scene.buffers(), asked, ways, unused);
      std::size_t at = 0;
      for (const Lit& lit : drawn) {
        if ((lit.lobe & lobes::LOBE_DELTA) != 0) continue;
        const Lit& told = again[at++];
        if (lit.weight[0] <= 0) continue;
        CHECK(told.density == Approx(lit.drawn_density).epsilon(2e-4));
        for (std::size_t k = 0; k < 3; ++k)
          CHECK(told.value[k] == Approx(lit.weight[k] * lit.drawn_density).epsilon(2e-4));
      }
    }
  }
}

TEST_CASE("white under clear glass reflects at most all, and gives back what it takes") {
  for (const TransportTier& tier : transport_tiers()) {
    const TierScene scene(coated(Diffuse{{{1, 1, 1}}}, Coat{}), tier);
    std::vector<SeenPlace> out;
    std::vector<Triad> in, numbers;
    for (const double a : cosines)
      for (const double b : cosines) {
        out.push_back({0.5, 0.5, 0.5, direction(a, 0.2)});
        in.push_back(direction(b, 0.7));
        numbers.push_back({0.5, 0.5, 0.5});
      }
    std::vector<SeenPlace> back;
    std::vector<Triad> to;
    for (std::size_t i = 0; i < out.size(); ++i) {
      back.push_back({0.5, 0.5, 0.5, in[i]});
      to.push_back(out[i].out);
    }
    const std::vector<Lit> one = tier.lit(scene.buffers(), out, in, numbers);
    const std::vector<Lit> other = tier.lit(scene.buffers(), back, to, numbers);
    for (std::size_t i = 0; i < one.size(); ++i) {
      INFO(tier.name << ", cosines " << out[i].out[2] << " and " << in[i][2]);
      CHECK(one[i].value[0] * out[i].out[2] ==
            Approx(other[i].value[0] * in[i][2]).epsilon(1000 * roundoff(tier)).margin(1e-30));
    }
  }
}

TEST_CASE("every width draws under a coat as one lane does, to the bit") {
  std::map<std::string, TransportTier> narrow;
  for (const TransportTier& tier : transport_tiers())
    if (tier.lanes == 1) narrow.emplace(tier.name, tier);
  std::mt19937_64 engine(9);
  std::vector<SeenPlace> places;
  std::vector<Triad> wi, numbers;
  for (int i = 0; i < 99; ++i) {
    places.push_back({0.5, 0.5, unit_number(engine), direction(2 * unit_number(engine) - 1, unit_number(engine))});
    wi.push_back(direction(2 * unit_number(engine) - 1, unit_number(engine)));
    numbers.push_back({unit_number(engine), unit_number(engine), unit_number(engine)});
  }
  for (const TransportTier& tier : transport_tiers()) {
    if (tier.lanes == 1) continue;
    INFO(tier.name << ", " << tier.lanes << " lanes");
    const Scene scene = coated(Plastic{}, amber());
    const auto wide = tier.lit(TierScene(scene, tier).buffers(), places, wi, numbers);
    const auto one = narrow.at(tier.name).lit(TierScene(scene, narrow.at(tier.name)).buffers(), places, wi, numbers);
    for (std::size_t i = 0; i < wide.size(); ++i) {
      CHECK(wide[i].value == one[i].value);
      CHECK(wide[i].density == one[i].density);
      CHECK(wide[i].drawn == one[i].drawn);
      CHECK(wide[i].weight == one[i].weight);
    }
  }
}

/// Both mirrors throw light to the same place: what the glass mirrors, and what goes through it twice.
TEST_CASE("a mirror under a coat shows what both mirror, by path and by whitted") {
  Scene scene = coated(Conductor{{{0.5, 0.7, 0.9}}}, amber());
  scene.lights.emplace_back().emitter = ConstantLight{{1, 1, 1}};
  const Coat coat = amber();
  const double cosine = 0.8, sine = 0.6;
  const Triad seen = {sine, 0, cosine};
  const double reflected = static_cast<double>(boundary(cosine, coat.int_ior / coat.ext_ior).reflectance);
  const std::array<Real, 3> share = left(coat, seen, seen);
  const std::array tint{0.9, 0.8, 0.7}, below{0.5, 0.7, 0.9};
  const GivenRay ray{{sine, 0, cosine}, {-sine, 0, -cosine}, 0, 1e30};
  for (const char* integrator : {"path", "whitted"})
    for (const TransportTier& tier : transport_tiers()) {
      INFO(tier.name << ", " << tier.lanes << " lanes, " << integrator);
      scene.integrator.name = integrator;
      std::array<std::vector<double>, 3> values;
      for (const Triad& one : tier.radiance(TierScene(scene, tier).buffers(), ray, 2048))
        for (std::size_t k = 0; k < 3; ++k) values[k].push_back(one[k]);
      for (std::size_t k = 0; k < 3; ++k) {
        const double expected = reflected * tint[k] + static_cast<double>(share[k]) * below[k];
        const Mean mean = mean_of(values[k]);
        CHECK(mean.value == Approx(expected).epsilon(0).margin(5 * mean.noise + 100 * roundoff(tier)));
        if (std::string(integrator) == "whitted") CHECK(mean.noise < 1e-12);
      }
    }
}

}  // namespace
