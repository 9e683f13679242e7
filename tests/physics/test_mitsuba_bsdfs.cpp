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

struct Case {
  std::string bsdf, kind;
  int entry = 0;
  std::vector<double> p;
  double alpha = 1;  ///< The least.
};

Case read_case(const std::string& bsdf) {
  const strahl::Material material = load_body(bsdf).scene.materials.at(1);
  const strahl::MaterialFacts facts = strahl::material_facts(material);
  Case found;
  found.bsdf = bsdf;
  found.kind = facts.kind;
  for (const strahl::MaterialSlot& slot : facts.slots) {
    found.p.insert(found.p.end(), slot.reals.begin(), slot.reals.end());
    if (std::string(slot.name).starts_with("alpha")) found.alpha = std::min(found.alpha, slot.reals[0]);
  }
  const std::vector<BsdfEntry> entries = bsdf_entries();
  const auto entry =
      std::find_if(entries.begin(), entries.end(), [&](const BsdfEntry& each) { return each.name == facts.kind; });
  REQUIRE(entry != entries.end());
  found.entry = static_cast<int>(entry - entries.begin());
  return found;
}

TEST_CASE("materials scatter what Mitsuba's do") {
  std::ifstream file(STRAHL_SOURCE_DIR "/tests/physics/mitsuba_bsdfs.txt");
  REQUIRE(file);
  Case material;
  int values = 0;
  for (std::string line; std::getline(file, line);) {
    if (line[0] == '#') continue;
    if (line[0] == '<') {
      material = read_case(line);
      continue;
    }
    std::istringstream numbers(line);
    Triad wo, wi, wanted;
    for (Triad* triad : {&wo, &wi, &wanted})
      for (double& x : *triad) numbers >> x;
    REQUIRE(numbers);
    ++values;
    const double half = std::hypot(wo[0] + wi[0], wo[1] + wi[1], wo[2] + wi[2]) / 2;
    const double single = 3e-5 * (1 + 1 / (material.alpha * half));
    // Mitsuba's table has a step of 1 / 63 in the cosine, which its interpolation feels where light is shallow.
    const double tabulated = std::min(wo[2], wi[2]) < 0.1 ? 1.5e-2 : 3e-3;
    const double bound = material.kind == "roughplastic" ? tabulated + single : single;
    for (const BsdfTier& tier : bsdf_tiers()) {
      if (tier.lanes == 16 || (tier.lanes == 1 && std::string(tier.name) != "double")) continue;
      INFO(tier.name << ", " << material.bsdf << "\n" << line);
      const Scattered found = tier.eval(material.entry, material.p, wo, {wi}).front();
      for (std::size_t i = 0; i < 3; ++i) CHECK(found.value[i] == Approx(wanted[i]).epsilon(bound).margin(1e-7));
    }
  }
  CHECK(values > 290);
}

}  // namespace
