// SPDX-License-Identifier: MIT
// Materials as scene files have them, read and evaluated, against values of Mitsuba 3 (mitsuba_bsdfs.txt, written by
// tests/acceptance/mitsuba_bsdfs.py). Mitsuba's are in single precision; what roughplastic lets through is tabulated
// there and a polynomial here.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <sstream>

#include "kinds/materials.h"
#include "physics/bsdf_tiers.h"
#include "scene/scene_text.h"

using namespace strahl::test;

namespace {

/// A single material, or one among those of a blend.
struct Case {
  std::string kind;
  int entry = 0;
  std::vector<double> p;
  double alpha = 1;  ///< The least.
  double share = 1;  ///< Of the light.
  bool is_twosided = false;
};

void add_cases(const strahl::Scene& scene, const strahl::Material& material, double share, std::vector<Case>& cases) {
  const strahl::MaterialFacts facts = strahl::material_facts(material);
  if (!facts.nested.empty()) {
    const double weight = facts.slots.at(0).reals[0];
    for (const std::size_t i : {0, 1}) {
      const auto row = static_cast<std::size_t>(facts.nested.at(i));
      add_cases(scene, scene.materials.at(row), share * (i == 0 ? 1 - weight : weight), cases);
    }
    return;
  }
  Case& found = cases.emplace_back();
  found.kind = facts.kind;
  found.share = share;
  found.is_twosided = facts.is_twosided;
  for (const strahl::MaterialSlot& slot : facts.slots) {
    found.p.insert(found.p.end(), slot.reals.begin(), slot.reals.end());
    const std::string name = slot.name;
    if (name.starts_with("alpha")) found.alpha = std::min(found.alpha, slot.reals[0]);
    // Times the least that anisotropy leaves.
    if (name == "roughness") found.alpha = std::min(found.alpha, 0.3 * slot.reals[0] * slot.reals[0]);
    if (name == "clearcoat_gloss") found.alpha = std::min(found.alpha, 0.1 - 0.099 * slot.reals[0]);
  }
  const std::vector<BsdfEntry> entries = bsdf_entries();
  const auto entry =
      std::find_if(entries.begin(), entries.end(), [&](const BsdfEntry& each) { return each.name == facts.kind; });
  REQUIRE(entry != entries.end());
  found.entry = static_cast<int>(entry - entries.begin());
}

std::vector<Case> read_cases(const std::string& bsdf) {
  const strahl::Scene scene = load_body(bsdf).scene;
  std::vector<Case> cases;
  add_cases(scene, scene.materials.back(), 1, cases);
  return cases;
}

Triad value_of(const BsdfTier& tier, const std::vector<Case>& cases, const Triad& wo, const Triad& wi) {
  Triad sum{};
  for (const Case& one : cases) {
    const double side = one.is_twosided && wo[2] < 0 ? -1 : 1;
    const Triad from{wi[0], wi[1], side * wi[2]};
    const Scattered found = tier.eval(one.entry, one.p, {wo[0], wo[1], side * wo[2]}, {from}).front();
    for (std::size_t i = 0; i < 3; ++i) sum[i] += one.share * found.value[i];
  }
  return sum;
}

TEST_CASE("materials scatter what Mitsuba's do") {
  std::ifstream file(STRAHL_SOURCE_DIR "/tests/physics/mitsuba_bsdfs.txt");
  REQUIRE(file);
  std::string bsdf;
  std::vector<Case> cases;
  int values = 0;
  for (std::string line; std::getline(file, line);) {
    if (line[0] == '#') continue;
    if (line[0] == '<') {
      bsdf = line;
      cases = read_cases(line);
      continue;
    }
    std::istringstream numbers(line);
    Triad wo, wi, wanted;
    for (Triad* triad : {&wo, &wi, &wanted})
      for (double& x : *triad) numbers >> x;
    REQUIRE(numbers);
    ++values;
    const double half = std::hypot(wo[0] + wi[0], wo[1] + wi[1], wo[2] + wi[2]) / 2;
    double alpha = 1;
    bool is_tabulated = false, is_thinner = false;
    for (const Case& one : cases) {
      alpha = std::min(alpha, one.alpha);
      is_tabulated = is_tabulated || one.kind == "roughplastic";
      is_thinner = is_thinner || (one.kind == "roughplastic" && one.p.at(6) < 1);
    }
    const double single = std::min(3e-5 * (1 + 1 / (alpha * half)), 2e-2);
    // Mitsuba's table has a step of 1 / 63 in the cosine, which its interpolation feels where light is shallow.
    const double tabulated = std::min(wo[2], wi[2]) < 0.1 ? 1.5e-2 : 3e-3;
    const double bound = is_tabulated ? tabulated + single : single;
    // Beyond the critical angle of something thinner next to nothing goes through, by the polynomial up to 0.006.
    const double margin = is_thinner ? 2e-3 : 1e-7;
    for (const BsdfTier& tier : bsdf_tiers()) {
      if (tier.lanes == 16 || (tier.lanes == 1 && std::string(tier.name) != "double")) continue;
      INFO(tier.name << ", " << bsdf << "\n" << line);
      const Triad found = value_of(tier, cases, wo, wi);
      for (std::size_t i = 0; i < 3; ++i) CHECK(found[i] == Approx(wanted[i]).epsilon(bound).margin(margin));
    }
  }
  CHECK(values > 640);
}

}  // namespace
