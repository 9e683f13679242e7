// SPDX-License-Identifier: MIT
// Rough materials where their lobes are narrow or light is grazing: draws against the stated density by chi^2 over the
// slopes of half vectors in units of alpha, in which every lobe is smooth; the density's integral; what is finite at
// all. Bins are those of polar coordinates. 3 s.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "kinds/materials.h"
#include "physics/bsdf_tiers.h"
#include "physics/statistics.h"

using namespace strahl::test;

namespace {

using namespace strahl::lobes;

constexpr int sectors = 8, within = 12;
const std::vector<double> radii{0, 0.25, 0.5, 0.75, 1, 1.25, 1.5, 2, 3};

struct Rough {
  double alpha_u, alpha_v;
  bool is_ggx, is_visible;
  double eta = 0;  ///< Of glass; 0: metal.
};

int entry_of(const Rough& rough) {
  const std::string name = rough.eta > 0 ? "roughdielectric" : "roughconductor";
  const std::vector<BsdfEntry> entries = bsdf_entries();
  const auto found =
      std::find_if(entries.begin(), entries.end(), [&](const BsdfEntry& entry) { return entry.name == name; });
  REQUIRE(found != entries.end());
  return static_cast<int>(found - entries.begin());
}

/// White.
std::vector<double> parameters(const Rough& rough) {
  std::vector<double> p{1, 1, 1, 0, 0, 0, 1, 1, 1};
  if (rough.eta > 0) p = {1, 1, 1, 1, 1, 1, rough.eta, rough.eta, 1};
  p.insert(p.end(),
           {rough.alpha_u, 0, 0, rough.alpha_v, 0, 0, rough.is_ggx ? 1.0 : 0.0, rough.is_visible ? 1.0 : 0.0, 0});
  return p;
}

double dot(const Triad& a, const Triad& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Triad unit(const Triad& a) {
  const double length = std::sqrt(dot(a, a));
  return {a[0] / length, a[1] / length, a[2] / length};
}

Triad towards(double cosine, double turn) {
  const double sine = std::sqrt((1 - cosine) * (1 + cosine));
  return {sine * std::cos(2 * std::numbers::pi * turn), sine * std::sin(2 * std::numbers::pi * turn), cosine};
}

std::vector<Triad> numbers_to_draw_by(std::size_t count) {
  std::mt19937_64 engine(9);
  std::vector<Triad> numbers(count);
  for (Triad& triple : numbers) triple = {unit_number(engine), unit_number(engine), unit_number(engine)};
  return numbers;
}

/// A place of the plane of slopes: the direction that the normal there reflects or refracts wo to, and solid angle per
/// area.
struct Place {
  Triad wi;
  double angle;
};

Place place_of(const Rough& rough, const Triad& wo, double x, double y, bool is_reflected) {
  const Triad slope{rough.alpha_u * x, rough.alpha_v * y, 1}, m = unit(slope);
  const double cosine = dot(wo, m), normals = rough.alpha_u * rough.alpha_v * m[2] * m[2] * m[2], eta = rough.eta;
  if (is_reflected) {
    const Triad wi{2 * cosine * m[0] - wo[0], 2 * cosine * m[1] - wo[1], 2 * cosine * m[2] - wo[2]};
    return {wi, wi[2] > 0 ? 4 * std::fabs(cosine) * normals : 0};
  }
  const double far2 = 1 - (1 - cosine) * (1 + cosine) / (eta * eta);
  if (cosine <= 0 || far2 <= 0) return {{0, 0, 1}, 0};
  const double far = std::sqrt(far2), along = cosine / eta - far, sum = cosine - eta * far;
  const Triad wi{along * m[0] - wo[0] / eta, along * m[1] - wo[1] / eta, along * m[2] - wo[2] / eta};
  return {wi, wi[2] < 0 ? sum * sum / (eta * eta * far) * normals : 0};
}

/// Part of a ring and a sector, of the plane of slopes in polar coordinates.
struct Cell {
  std::size_t bin;
  double r, phi, width, turn;  ///< Begin and extent.
  int level;
};

/// The density ends where a direction would leave on the other side of the surface, and within no bin is it smooth
/// there: cells with that line in them are halved both ways, five times.
std::vector<Cell> cells_of(const Rough& rough, const Triad& wo, bool is_reflected) {
  const auto is_lit = [&](double r, double phi) {
    return place_of(rough, wo, r * std::cos(phi), r * std::sin(phi), is_reflected).angle > 0;
  };
  std::vector<Cell> open, done;
  const double turn = 2 * std::numbers::pi / (sectors * within);
  for (std::size_t ring = 0; ring + 1 < radii.size(); ++ring) {
    const double width = (radii[ring + 1] - radii[ring]) / within;
    for (int i = 0; i < within; ++i)
      for (int j = 0; j < sectors * within; ++j)
        open.push_back(
            {ring * sectors + static_cast<std::size_t>(j / within), radii[ring] + i * width, j * turn, width, turn, 0});
  }
  while (!open.empty()) {
    const Cell cell = open.back();
    open.pop_back();
    const double r = cell.r + cell.width, phi = cell.phi + cell.turn, half = cell.width / 2, half_turn = cell.turn / 2;
    const int corners = is_lit(cell.r, cell.phi) + is_lit(r, cell.phi) + is_lit(cell.r, phi) + is_lit(r, phi);
    if (corners == 0) continue;
    if (corners == 4 || cell.level == 5) {
      done.push_back(cell);
      continue;
    }
    for (const double more : {0.0, half})
      for (const double later : {0.0, half_turn})
        open.push_back({cell.bin, cell.r + more, cell.phi + later, half, half_turn, cell.level + 1});
  }
  return done;
}

/// What share of all draws each bin ought to have, by the stated density.
std::vector<double> shares_of_bins(const BsdfTier& tier, const Rough& rough, const Triad& wo) {
  std::vector<double> shares((radii.size() - 1) * sectors, 0), areas;
  std::vector<std::size_t> bins;
  std::vector<Triad> wis;
  for (const bool is_reflected : {true, false}) {
    if (!is_reflected && rough.eta == 0) continue;
    for (const Cell& cell : cells_of(rough, wo, is_reflected)) {
      const double r = cell.r + cell.width / 2, phi = cell.phi + cell.turn / 2;
      const Place place = place_of(rough, wo, r * std::cos(phi), r * std::sin(phi), is_reflected);
      bins.push_back(cell.bin);
      wis.push_back(place.wi);
      areas.push_back(place.angle * r * cell.width * cell.turn);
    }
  }
  const std::vector<Scattered> found = tier.eval(entry_of(rough), parameters(rough), wo, wis);
  for (std::size_t k = 0; k < found.size(); ++k) shares[bins[k]] += found[k].density * areas[k];
  return shares;
}

void hold_draws(const BsdfTier& tier, const Rough& rough, const Triad& wo, const std::vector<Triad>& numbers) {
  std::vector<double> expected = shares_of_bins(tier, rough, wo), hits(expected.size(), 0);
  double beyond = 0, absorbed = 0, misplaced = 0;
  const auto n = static_cast<double>(numbers.size());
  for (const Way& way : tier.sample(entry_of(rough), parameters(rough), wo, LOBES_ALL, numbers)) {
    if (way.density == 0) {
      absorbed += 1;
      continue;
    }
    const double by = way.wi[2] > 0 ? 1 : rough.eta;
    const Triad half{wo[0] + by * way.wi[0], wo[1] + by * way.wi[1], wo[2] + by * way.wi[2]};
    const double x = half[0] / half[2] / rough.alpha_u, y = half[1] / half[2] / rough.alpha_v, r = std::hypot(x, y);
    if (r >= radii.back()) {
      beyond += 1;
      continue;
    }
    // Where both directions are shallow and opposite, their sum is rounding to a part, and may lie across the line.
    if (place_of(rough, wo, x, y, way.wi[2] > 0).angle <= 0) {
      misplaced += 1;
      continue;
    }
    const auto ring = std::upper_bound(radii.begin(), radii.end(), r) - radii.begin() - 1;
    const double turn = std::atan2(y, x) / (2 * std::numbers::pi);
    hits[static_cast<std::size_t>(ring * sectors + static_cast<int>((turn + 1) * sectors) % sectors)] += 1;
  }
  const double whole = std::accumulate(expected.begin(), expected.end(), 0.0),
               others = (beyond + absorbed + misplaced) / n;
  CHECK(misplaced <= 5 + 5e4 * roundoff(tier) * n);  // 0.3 % in single precision, none in double.
  CHECK(whole + others == Approx(1).margin(1e-3 + 4 * std::sqrt(others * (1 - others) / n)));
  for (double& share : expected) share *= n;
  hold_counts(hits, expected);
}

const std::vector<Rough>& roughs() {
  static const std::vector<Rough> all{
      {1e-4, 1e-4, false, true},      {1e-4, 1e-4, true, true},    {0.01, 0.01, false, true},
      {0.01, 0.01, true, true},       {0.1, 0.1, false, true},     {0.1, 0.1, true, true},
      {0.5, 0.5, false, true},        {0.05, 0.4, false, true},    {0.4, 0.05, true, true},
      {0.1, 0.02, false, false},      {0.02, 0.1, true, false},    {1e-4, 0.3, false, true},
      {0.01, 0.01, false, true, 1.5}, {0.1, 0.1, true, true, 0.7}, {0.05, 0.3, true, true, 1.33},
      {0.1, 0.1, false, false, 2}};
  return all;
}

TEST_CASE("narrow and grazing lobes are drawn as densely as is said, and their density integrates to 1") {
  const std::vector<Triad> numbers = numbers_to_draw_by(draws_asked(10000));
  for (const BsdfTier& tier : bsdf_tiers()) {
    if (tier.lanes == 1 || tier.lanes == 16) continue;
    for (const Rough& rough : roughs())
      for (const double cosine : {1.0, 0.7, 0.3, 0.05, 1e-3, 1e-7}) {
        // Slopes across the plane of incidence are known as well as directions are.
        const double least = std::min(rough.alpha_u, rough.alpha_v), most = std::max(rough.alpha_u, rough.alpha_v);
        if (roundoff(tier) / std::max(2 * cosine, most) > 0.02 * least) continue;
        INFO(tier.name << ", alpha " << rough.alpha_u << " " << rough.alpha_v << (rough.is_ggx ? " GGX" : " Beckmann")
                       << (rough.is_visible ? "" : ", all normals") << ", eta " << rough.eta << ", cosine " << cosine);
        hold_draws(tier, rough, towards(cosine, 0.3), numbers);
      }
  }
}

void hold_finite(const BsdfTier& tier, const Rough& rough, double cosine) {
  constexpr double least = 0x1p-24;
  static const std::vector<Triad> numbers{{0.5, least, least},      {0.01, 1 - least, least},
                                          {0.99, least, 1 - least}, {0.5, 1 - least, 1 - least},
                                          {least, 0.5, 0.5},        {1 - least, 0.25, 0.75}};
  INFO(tier.name << ", " << tier.lanes << " lanes, alpha " << rough.alpha_u << (rough.is_ggx ? " GGX" : " Beckmann")
                 << ", visible " << rough.is_visible << ", eta " << rough.eta << ", cosine " << cosine);
  const Triad wo = towards(cosine, 0.1);
  std::vector<Triad> wis{{0, 0, 1}, wo, {-wo[0], -wo[1], wo[2]}, {-wo[0], -wo[1], -wo[2]}};
  for (const Way& way : tier.sample(entry_of(rough), parameters(rough), wo, LOBES_ALL, numbers)) {
    REQUIRE(std::isfinite(way.density));
    REQUIRE(way.density >= 0);
    for (std::size_t i = 0; i < 3; ++i) {
      REQUIRE(std::isfinite(way.wi[i]));
      REQUIRE(std::isfinite(way.weight[i]));
      REQUIRE(way.weight[i] >= 0);
    }
    wis.push_back(way.wi);
  }
  for (const Scattered& there : tier.eval(entry_of(rough), parameters(rough), wo, wis)) {
    REQUIRE(std::isfinite(there.density));
    REQUIRE(std::isfinite(there.value[0]));
    REQUIRE(there.density >= 0);
    REQUIRE(there.value[0] >= 0);
  }
}

TEST_CASE("every weight, density and value is finite, for any direction and number") {
  for (const BsdfTier& tier : bsdf_tiers())
    for (const double alpha : {0.0, 1e-6, 1e-4, 1e-3, 0.1, 1.0, 5.0})
      for (const bool is_ggx : {false, true})
        for (const bool is_visible : {false, true})
          for (const double eta : {0.0, 1.5, 0.6, 1.0001})
            for (const double cosine : {1.0, 1 - 1e-7, 0.5, 1e-3, 1e-7, 1e-20, 0.0, -1e-7, -1.0})
              hold_finite(tier, {alpha, alpha, is_ggx, is_visible, eta}, cosine);
}

TEST_CASE("roughness below 1e-4 is 1e-4") {
  for (const BsdfTier& tier : bsdf_tiers())
    for (const bool is_ggx : {false, true}) {
      const Triad wo = towards(0.8, 0.2), wi{-wo[0], -wo[1], wo[2]};
      const Scattered none = tier.eval(entry_of({}), parameters({0, 1e-5, is_ggx, true}), wo, {wi}).front(),
                      least = tier.eval(entry_of({}), parameters({1e-4, 1e-4, is_ggx, true}), wo, {wi}).front();
      CHECK(none.density == least.density);
      CHECK(none.density > 1e6);
    }
}

}  // namespace
