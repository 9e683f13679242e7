// SPDX-License-Identifier: MIT
// Checks every material of cl/materials/materials.def in every tier and width: directions are drawn with the stated
// density (chi^2); densities integrate to the share of non-delta lobes; weights are f |cos| over the density; f is
// reciprocal; energy is not created (nor lost where the material is lossless); delta lobes are reversible. A new entry
// is tested with its default parameters, and with its rows in material_rows.h. 2 s.
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <random>

#include "physics/bsdf_tiers.h"
#include "physics/material_rows.h"
#include "physics/sphere_bins.h"

using namespace strahl::test;

namespace {

using namespace strahl::lobes;

/// By how much rounding changes a density or value at a drawn direction, relative to it: a rough lobe is as steep as it
/// is narrow, a half vector is known as well as it is long, and shallow light on a microfacet changes what it reflects.
double rounding(const BsdfTier& tier, const MaterialRow& row, double index, const Triad& wo, const Way& way) {
  const double u = 64 * roundoff(tier);
  if (row.spread == 1) return u;
  const Triad half{wo[0] + way.eta * way.wi[0], wo[1] + way.eta * way.wi[1], wo[2] + way.eta * way.wi[2]};
  const double length = std::hypot(half[0], half[1], half[2]);
  const auto cosine = [&](const Triad& w) {
    return std::fabs(half[0] * w[0] + half[1] * w[1] + half[2] * w[2]) / length;
  };
  double least = 1;
  if (index != 1) {
    // The square of the cosine on the other side vanishes at the critical angle.
    const double eta = wo[2] < 0 ? 1 / index : index, c = cosine(wo);
    least = std::min({c, cosine(way.wi), std::sqrt(std::fabs(eta * eta - (1 - c) * (1 + c)))});
  }
  return std::min(u * (1 + 2 / (row.spread * length)) / (least * least), 1.0);
}

/// Index of refraction inside over outside; 1: light goes through straight, or not at all.
double index_of(const BsdfEntry& entry, const MaterialRow& row) {
  if (entry.name == "principled") return row.p[33];
  return entry.name == "principledthin" || (entry.lobes & LOBE_TRANSMIT) == 0 ? 1 : row.p[6];
}

/// Towards the camera: above and below, upright to grazing.
std::vector<Triad> directions() {
  std::vector<Triad> all;
  for (const double cosine : {1.0, 0.9, 0.6, 0.3, 0.05, 1e-3, -0.02, -0.5, -0.95, -1.0}) {
    const double sine = std::sqrt((1 - cosine) * (1 + cosine)), turn = 1 + 2 * cosine;
    all.push_back({sine * std::cos(turn), sine * std::sin(turn), cosine});
  }
  return all;
}

std::vector<Triad> random_numbers(std::size_t count) {
  std::mt19937_64 engine(7);
  std::vector<Triad> numbers(count);
  for (Triad& triple : numbers) triple = {unit_number(engine), unit_number(engine), unit_number(engine)};
  return numbers;
}

bool is_black(const Triad& v) { return v[0] == 0 && v[1] == 0 && v[2] == 0; }
double largest(const Triad& v) { return std::max({v[0], v[1], v[2]}); }
bool is_delta(const Way& way) { return (way.lobe & LOBE_DELTA) != 0; }

/// visit(tier, kind, entry, row, wo)
template <class Visit>
void for_each_case(Visit visit, const std::vector<BsdfTier>& tiers = asked_widths(bsdf_tiers())) {
  const std::vector<BsdfEntry> entries = bsdf_entries();
  for (const BsdfTier& tier : tiers)
    for (std::size_t kind = 0; kind < entries.size(); ++kind) {
      const BsdfEntry& entry = entries[kind];
      for (const MaterialRow& row : material_rows_of(entry.name))
        for (const Triad& wo : directions()) {
          INFO(tier.name << ", " << tier.lanes << " lanes, " << entry.name << " " << Catch::Detail::stringify(row.p)
                         << ", wo " << Catch::Detail::stringify(wo));
          visit(tier, static_cast<int>(kind), entry, row, wo);
        }
    }
}

TEST_CASE("every material has parameters here") {
  for (const BsdfEntry& entry : bsdf_entries()) {
    INFO("Material::bsdf has none of " << entry.name << ", or slots of other sizes");
    for (const MaterialRow& row : material_rows_of(entry.name)) REQUIRE(static_cast<int>(row.p.size()) == entry.reals);
    CHECK((entry.lobes & LOBE_SIDES) != 0);
    CHECK((entry.lobes & LOBE_SPREADS) != 0);
  }
}

TEST_CASE("directions are drawn as densely as is said, and densities integrate to what is no delta lobe") {
  const std::vector<Triad> numbers = random_numbers(draws_asked(4000));
  for_each_case([&](const BsdfTier& tier, int kind, const BsdfEntry& entry, const MaterialRow& row, const Triad& wo) {
    // Narrow lobes, as refracted ones are: test_microfacets.cpp, test_principled.cpp.
    const bool is_narrow = row.spread < 0.3 || (row.spread < 1 && (entry.lobes & LOBE_TRANSMIT) != 0);
    if ((entry.lobes & LOBE_SPREADS) == LOBE_DELTA || is_narrow) return;
    const std::vector<Way> ways = tier.sample(kind, row.p, wo, LOBES_ALL, numbers);
    const SphereBins bins = sphere_bins(tier, kind, row.p, wo, ways, 6);
    if (std::any_of(ways.begin(), ways.end(), [](const Way& way) { return !is_black(way.weight); }))
      bins.hold(static_cast<double>(ways.size()));
    else if (largest({row.p[0], row.p[1], row.p[2]}) > 0)
      CHECK(bins.whole() == 0);
  });
}

TEST_CASE("weights are f |cos| over the density, and f is reciprocal") {
  const std::vector<Triad> numbers = random_numbers(64);
  for_each_case([&](const BsdfTier& tier, int kind, const BsdfEntry& entry, const MaterialRow& row, const Triad& wo) {
    if ((entry.lobes & LOBE_SPREADS) == LOBE_DELTA) return;
    for (const Way& way : tier.sample(kind, row.p, wo, LOBES_ALL, numbers)) {
      if (is_delta(way) || is_black(way.weight)) continue;
      const double bound = rounding(tier, row, index_of(entry, row), wo, way);
      const Scattered there = tier.eval(kind, row.p, wo, {way.wi}).front();
      const Scattered back = tier.eval(kind, row.p, way.wi, {wo}).front();
      CHECK(there.density == Approx(way.density).epsilon(bound));
      for (std::size_t i = 0; i < 3; ++i) {
        CHECK(there.value[i] == Approx(way.weight[i] * way.density).epsilon(bound));
        // What a sheet's glass transmits is not, as in Mitsuba.
        if (entry.name == "principledthin" && (way.lobe & LOBE_TRANSMIT) != 0) continue;
        // Between media of different indices f / eta^2 is reciprocal.
        const double f = there.value[i] / std::fabs(way.wi[2]) * way.eta * way.eta;
        CHECK(f == Approx(back.value[i] / std::fabs(wo[2])).epsilon(bound));
      }
    }
  });
}

TEST_CASE("no material makes energy, and a lossless one loses none") {
  const std::vector<Triad> numbers = random_numbers(1024);
  for_each_case([&](const BsdfTier& tier, int kind, const BsdfEntry& entry, const MaterialRow& row, const Triad& wo) {
    double sum = 0, squares = 0;
    for (const Way& way : tier.sample(kind, row.p, wo, LOBES_ALL, numbers)) {
      // Radiance over the squared index is conserved.
      const double share = largest(way.weight) * way.eta * way.eta;
      CHECK(std::isfinite(share));
      CHECK(*std::min_element(way.weight.begin(), way.weight.end()) >= 0);
      sum += share;
      squares += share * share;
    }
    const double n = static_cast<double>(numbers.size()), mean = sum / n;
    const double noise = 4 * std::sqrt(std::max(squares / n - mean * mean, 0.0) / n) + 64 * roundoff(tier);
    // Beckmann's rational masking is up to 0.35 % too little.
    CHECK(mean <= row.most + noise + (row.spread < 1 ? 2e-3 : 0));
    const bool is_seen = wo[2] > 0 || (entry.lobes & LOBE_TRANSMIT) != 0;
    if (row.is_lossless && is_seen) CHECK(mean >= 1 - noise);
    if (!is_seen) CHECK(mean == 0);
  });
}

TEST_CASE("delta lobes lead where mirrors and Snell's law do, back again, and carry together what one of them does") {
  const std::vector<Triad> numbers = random_numbers(32);
  for_each_case([&](const BsdfTier& tier, int kind, const BsdfEntry& entry, const MaterialRow& row, const Triad& wo) {
    if ((entry.lobes & LOBE_DELTA) == 0) return;
    const double u = roundoff(tier);
    double together = 0;
    for (const int side : {LOBE_REFLECT, LOBE_TRANSMIT}) {
      if ((entry.lobes & side) == 0) continue;
      const Way way = tier.sample(kind, row.p, wo, LOBE_DELTA | side, {{0.5, 0.5, 0.5}}).front();
      if (is_black(way.weight)) continue;
      CHECK(way.lobe == (LOBE_DELTA | side));
      CHECK(way.density == 1);
      CHECK((way.wi[2] > 0) == ((wo[2] > 0) == (side == LOBE_REFLECT)));
      CHECK(std::hypot(way.wi[0], way.wi[1], way.wi[2]) == Approx(1).epsilon(4 * u));
      for (std::size_t i = 0; i < 2; ++i) CHECK(way.wi[i] * way.eta == Approx(-wo[i]).margin(8 * u));
      const Way back = tier.sample(kind, row.p, way.wi, LOBE_DELTA | side, {{0.5, 0.5, 0.5}}).front();
      // The angle of a refracted, nearly grazing direction is only as accurate as its cosine.
      const double ratio = std::max(way.eta, 1 / way.eta);
      const double known =
          16 * u * ratio * ratio / std::max(std::fabs(way.wi[2]), 1e-3) / std::max(std::fabs(wo[2]), 1e-3);
      for (std::size_t i = 0; i < 3; ++i) {
        CHECK(back.wi[i] == Approx(wo[i]).margin(known));
        CHECK(back.weight[i] * back.eta * back.eta == Approx(way.weight[i] * way.eta * way.eta).margin(known));
      }
      double chances = 0, drawn = 0;
      for (const Way& one : tier.sample(kind, row.p, wo, LOBES_ALL, numbers)) {
        if (one.lobe != way.lobe) continue;
        drawn += 1;
        chances = one.density;
        CHECK(one.wi == way.wi);
        for (std::size_t i = 0; i < 3; ++i)
          CHECK(one.weight[i] * one.density == Approx(way.weight[i]).epsilon(8 * u).margin(4 * u));
      }
      if (drawn > 0) together += chances;
    }
    if (together > 0 && row.is_lossless && (wo[2] > 0.1 || (entry.lobes & LOBE_TRANSMIT) == 0))
      CHECK(together <= 1 + 4 * u);
  });
}

TEST_CASE("every width draws and tells what one lane does, to the bit") {
  const std::vector<Triad> numbers = random_numbers(35),
                           points{{0.3, 0.2, 0}, {0.3, 0.2, 0}, {0.8, 0.2, 0}, {0.1, 0.9, 0}, {0.4, 0.4, 0},
                                  {0.9, 0.1, 0}, {0.6, 0.2, 0}, {0.7, 0.7, 0}, {0.2, 0.6, 0}};
  std::map<std::string, BsdfTier> narrow;
  for (const BsdfTier& tier : bsdf_tiers())
    if (tier.lanes == 1) narrow.emplace(tier.name, tier);
  const auto hold = [&](const BsdfTier& tier, int kind, const BsdfEntry&, const MaterialRow& row, const Triad& wo) {
    if (tier.lanes == 1) return;
    const BsdfTier& one = narrow.at(tier.name);
    const auto wide_ways = tier.sample(kind, row.p, wo, LOBES_ALL, numbers),
               ways = one.sample(kind, row.p, wo, LOBES_ALL, numbers);
    std::vector<Triad> wis;
    for (std::size_t i = 0; i < ways.size(); ++i) {
      CHECK(wide_ways[i].wi == ways[i].wi);
      CHECK(wide_ways[i].weight == ways[i].weight);
      CHECK(wide_ways[i].density == ways[i].density);
      CHECK(wide_ways[i].eta == ways[i].eta);
      CHECK(wide_ways[i].lobe == ways[i].lobe);
      wis.push_back(ways[i].wi);
    }
    const auto wide = tier.eval(kind, row.p, wo, wis), values = one.eval(kind, row.p, wo, wis);
    for (std::size_t i = 0; i < values.size(); ++i) {
      CHECK(wide[i].value == values[i].value);
      CHECK(wide[i].density == values[i].density);
    }
  };
  for_each_case(hold, bsdf_tiers());
  // A parameter is a constant or a texture, lane by lane.
  for (const BsdfTier& tier : bsdf_tiers()) {
    const std::vector<Triad> found = tier.parameters(points);
    for (std::size_t i = 0; i < points.size(); ++i) {
      INFO(tier.name << ", " << tier.lanes << " lanes, point " << i);
      const bool is_red = (points[i][0] > 0.5) == (points[i][1] > 0.5);
      CHECK(found[i] == (i % 2 == 0 ? Triad{0, 0, 1} : is_red ? Triad{1, 0, 0} : Triad{0, 1, 0}));
    }
  }
}

}  // namespace
