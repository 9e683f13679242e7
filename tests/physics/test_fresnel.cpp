// SPDX-License-Identifier: MIT
// Dielectrics and metals against Fresnel's equations in long double, in the hard cases: equal and nearly equal indices,
// the critical angle, grazing light, Brewster's angle; metals that hardly absorb or hardly refract. 1 s.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <complex>
#include <limits>

#include "kinds/materials.h"
#include "physics/bsdf_tiers.h"

using namespace strahl::test;

namespace {

using namespace strahl::lobes;

int kind_of(const std::string& name) {
  const std::vector<BsdfEntry> entries = bsdf_entries();
  const auto found =
      std::find_if(entries.begin(), entries.end(), [&](const BsdfEntry& entry) { return entry.name == name; });
  REQUIRE(found != entries.end());
  return static_cast<int>(found - entries.begin());
}
int dielectric() { return kind_of("dielectric"); }

Way way(const BsdfTier& tier, double cosine, double eta, int side) {
  const double sine = std::sqrt((1 - cosine) * (1 + cosine));
  return tier
      .sample(dielectric(), {1, 1, 1, 1, 1, 1, eta, eta, 1}, {sine, 0, cosine}, LOBE_DELTA | side, {{0.5, 0.5, 0.5}})
      .front();
}

double rounded(const BsdfTier& tier, double x) {
  return std::string(tier.name) == "double" ? x : static_cast<double>(static_cast<float>(x));
}
/// By sines and cosines of both angles: A. Fresnel, 1823.
long double exact(long double c, long double eta) {
  const long double t2 = 1 - (1 - c) * (1 + c) / (eta * eta);
  if (t2 < 0) return 1;
  const long double t = std::sqrt(t2), s = (c - eta * t) / (c + eta * t), p = (eta * c - t) / (eta * c + t);
  return (s * s + p * p) / 2;
}

TEST_CASE("the reflected share is Fresnel's") {
  for (const BsdfTier& tier : bsdf_tiers()) {
    const double u = roundoff(tier);
    for (const double any_eta : {1.5046, 1.333, 2.419, 100.0, 0.6646, 0.75, 0.01, 1.0001, 0.9999, 1.01}) {
      const double eta = rounded(tier, any_eta);
      double worst = 0;
      for (int i = 1; i <= 1000; ++i) {
        const double cosine = rounded(tier, i / 1000.0);
        const auto truth = static_cast<double>(exact(cosine, eta));
        const double share = way(tier, cosine, eta, LOBE_REFLECT).weight[0];
        REQUIRE(share >= 0);
        REQUIRE(share <= 1);
        // The tolerance includes the change caused by rounding the cosine and the index.
        const double near =
            std::fabs(static_cast<double>(exact(cosine * (1 + u), eta) - exact(cosine * (1 - u), eta))) +
            std::fabs(static_cast<double>(exact(cosine, eta * (1 + u)) - exact(cosine, eta * (1 - u))));
        worst = std::max(worst, std::fabs(share - truth) / (truth * u + near));
        const Way through = way(tier, cosine, eta, LOBE_TRANSMIT);
        REQUIRE(through.weight[0] * through.eta * through.eta + share == Approx(1).epsilon(4 * u));
      }
      INFO(tier.name << ", " << tier.lanes << " lanes, index " << eta);
      CHECK(worst < 16);
    }
  }
}

TEST_CASE("what goes through the boundary of a plastic keeps its digits where light is grazing") {
  for (const BsdfTier& tier : bsdf_tiers()) {
    const double u = roundoff(tier);
    for (const double any_eta : {1.49, 1.0001, 0.75, 2.4}) {
      const double eta = rounded(tier, any_eta);
      const auto through = [&](double c) {
        const long double n = eta,
                          t2 = 1 - (1 - static_cast<long double>(c)) * (1 + static_cast<long double>(c)) / (n * n);
        if (t2 < 0) return 0.0L;
        const long double t = std::sqrt(t2), s = c + n * t, p = n * c + t;
        return 2 * c * n * t * (1 / (s * s) + 1 / (p * p));
      };
      double worst = 0;
      for (const double any : {1.0, 0.7, 0.1, 1e-2, 1e-3, 1e-5, 1e-7}) {
        const double c = rounded(tier, any);
        if (through(c) == 0) continue;
        const double sine = std::sqrt((1 - c) * (1 + c));
        // A black mirror over a white base: what it reflects is what goes in and out, over its own cosine.
        const std::vector<double> p{1, 1, 1, 0, 0, 0, eta, 0.5, 0, 0, 1, 1};
        const double value = tier.eval(kind_of("plastic"), p, {sine, 0, c}, {{-sine, 0, c}}).front().value[0];
        const auto truth = static_cast<double>(through(c) * through(c) * c / std::acos(-1.0L));
        const double near = std::fabs(static_cast<double>(through(c * (1 + u)) - through(c * (1 - u)))) * 2;
        worst = std::max(worst, std::fabs(value / truth - 1) / (u + near / static_cast<double>(through(c))));
      }
      INFO(tier.name << ", " << tier.lanes << " lanes, index " << eta);
      CHECK(worst < 32);
    }
  }
}

TEST_CASE("equal indices reflect nothing and pass every direction as it came") {
  for (const BsdfTier& tier : bsdf_tiers())
    for (const double any : {1.0, 0.7, 1e-3, 1e-7, 1e-30, 0.0, -0.7, -1.0}) {
      INFO(tier.name << ", " << tier.lanes << " lanes, cosine " << any);
      const double cosine = rounded(tier, any);
      CHECK(way(tier, cosine, 1, LOBE_REFLECT).weight[0] == 0);
      const Way through = way(tier, cosine, 1, LOBE_TRANSMIT);
      CHECK(through.weight == Triad{1, 1, 1});
      CHECK(through.eta == 1);
      CHECK(through.wi[2] == Approx(-cosine).margin(2 * roundoff(tier)));
    }
}

TEST_CASE("at the critical angle and on either side of it everything is finite, and beyond it all is reflected") {
  for (const BsdfTier& tier : bsdf_tiers())
    for (const double any_eta : {1 / 1.5046, 0.75, 0.5, 1 / 2.419, 0.999, 0x1p-1 + 0x1p-20}) {
      const double eta = rounded(tier, any_eta);
      const double critical = rounded(tier, std::sqrt((1 - eta) * (1 + eta)));
      for (int step = -64; step <= 64; ++step) {
        const double cosine = critical * (1 + 2 * step * roundoff(tier));
        const Way back = way(tier, cosine, eta, LOBE_REFLECT), through = way(tier, cosine, eta, LOBE_TRANSMIT);
        INFO(tier.name << ", " << tier.lanes << " lanes, index " << eta << ", step " << step);
        REQUIRE(std::isfinite(back.weight[0]));
        REQUIRE(back.weight[0] <= 1);
        for (const double x : through.wi) REQUIRE(std::isfinite(x));
        REQUIRE(std::isfinite(through.weight[0]));
        if (step < -1) CHECK(back.weight[0] == 1);
        if (step < -1) CHECK(through.weight[0] == 0);
        if (step > 1) CHECK(through.weight[0] > 0);
      }
    }
}

TEST_CASE("at Brewster's angle half of the perpendicular share is all that is reflected") {
  for (const BsdfTier& tier : bsdf_tiers())
    for (const double eta : {1.5046, 1.333, 2.419}) {
      const double ratio = (1 - eta * eta) / (1 + eta * eta);
      const double share = way(tier, 1 / std::sqrt(1 + eta * eta), eta, LOBE_REFLECT).weight[0];
      CHECK(share == Approx(0.5 * ratio * ratio).epsilon(32 * roundoff(tier)));
    }
}

TEST_CASE("grazing light is reflected, whole") {
  for (const BsdfTier& tier : bsdf_tiers())
    for (const double eta : {1.5046, 0.6646})
      for (const double cosine : {0.0, 1e-30, 1e-12}) {
        const double share = way(tier, cosine, eta, LOBE_REFLECT).weight[0];
        CHECK(std::isfinite(share));
        CHECK(share == Approx(1).epsilon(1e-6));
      }
}

/// By the complex cosine inside.
long double exact_metal(long double c, long double n, long double k) {
  const std::complex<long double> index(n, k), inside = std::sqrt(index * index - (1 - c) * (1 + c)),
                                               square = index * index;
  return (std::norm((c - inside) / (c + inside)) + std::norm((square * c - inside) / (square * c + inside))) / 2;
}

TEST_CASE("metals reflect Fresnel's share") {
  const std::vector<std::array<double, 2>> indices{{0.143, 3.98}, {1.44, 1.6}, {0.2, 3.9}, {1.66, 9.22}, {4.37, 3.5},
                                                   {1.5, 0},      {1.0001, 0}, {1, 1e-4},  {1, 1e-3},    {0.7, 1e-6},
                                                   {1e-3, 1e-3},  {1e-3, 2},   {50, 0.1},  {0.5, 0.5},   {2.5, 1e-5}};
  const std::vector<double> cosines{1, 0.999, 0.9, 0.7, 0.5, 0.3, 0.1, 0.03, 1e-2, 1e-3, 1e-5, 1e-7};
  for (const BsdfTier& tier : bsdf_tiers()) {
    const double u = roundoff(tier);
    for (const auto& [any_n, any_k] : indices)
      for (const double any_cosine : cosines) {
        const double n = rounded(tier, any_n), k = rounded(tier, any_k), c = rounded(tier, any_cosine);
        const Triad wo{std::sqrt((1 - c) * (1 + c)), 0, c};
        const double share =
            tier.sample(kind_of("conductor"), {1, 1, 1, n, n, n, k, k, k}, wo, LOBES_ALL, {{0.5, 0.5, 0.5}})
                .front()
                .weight[0];
        const auto truth = static_cast<double>(exact_metal(c, n, k));
        const auto change = [&](double dc, double dn, double dk) {
          return std::fabs(
              static_cast<double>(exact_metal(std::min(c * (1 + dc * u), 1.0), n * (1 + dn * u), k * (1 + dk * u)) -
                                  exact_metal(c * (1 - dc * u), n * (1 - dn * u), k * (1 - dk * u))));
        };
        const double bound = 12 * (truth * u + change(1, 0, 0) + change(0, 1, 0) + change(0, 0, 1));
        INFO(tier.name << ", " << tier.lanes << " lanes, index " << n << " + i " << k << ", cosine " << c);
        CHECK(share == Approx(truth).margin(bound).epsilon(0));
        CHECK(share <= 1);
      }
    // No index: everything, at every angle.
    for (const double c : {1.0, 0.3, 1e-7})
      CHECK(tier.sample(kind_of("conductor"), {1, 1, 1, 0, 0, 0, 1, 0, 3}, {std::sqrt((1 - c) * (1 + c)), 0, c},
                        LOBES_ALL, {{0.5, 0.5, 0.5}})
                .front()
                .weight == Triad{1, 1, 1});
  }
}

}  // namespace
