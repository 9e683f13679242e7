// SPDX-License-Identifier: MIT
// The dielectric against Fresnel's equations in long double, in the hard cases: equal and nearly equal indices, the
// critical angle, grazing light, Brewster's angle. 1 s.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "kinds/materials.h"
#include "physics/bsdf_tiers.h"

using namespace strahl::test;

namespace {

using namespace strahl::lobes;

int dielectric() {
  const std::vector<BsdfEntry> entries = bsdf_entries();
  const auto found =
      std::find_if(entries.begin(), entries.end(), [](const BsdfEntry& entry) { return entry.name == "dielectric"; });
  REQUIRE(found != entries.end());
  return static_cast<int>(found - entries.begin());
}

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

}  // namespace
