// SPDX-License-Identifier: MIT
// The lobes of principled and principledthin together: draws against the stated density by chi^2, and the density's
// integral, over a grid that is fine enough for the narrowest of them; finite at grazing light and at the least
// roughness. 10 s.
#include <catch2/catch.hpp>
#include <cmath>

#include "kinds/materials.h"
#include "physics/bsdf_tiers.h"
#include "physics/sphere_bins.h"

using namespace strahl::test;

namespace {

using namespace strahl::lobes;

strahl::Varying grey(double value) { return {{value, value, value}}; }

template <class Bsdf>
std::vector<double> parameters(const Bsdf& bsdf) {
  strahl::Material material;
  material.bsdf = bsdf;
  std::vector<double> p;
  for (const strahl::MaterialSlot& slot : strahl::material_facts(material).slots)
    p.insert(p.end(), slot.reals.begin(), slot.reals.end());
  return p;
}

strahl::Principled principled(double roughness, double metallic, double spec_trans, double clearcoat) {
  strahl::Principled bsdf;
  bsdf.base_color = {{0.9, 0.6, 0.3}};
  bsdf.roughness = grey(roughness);
  bsdf.metallic = grey(metallic);
  bsdf.spec_trans = grey(spec_trans);
  bsdf.clearcoat = grey(clearcoat);
  bsdf.sheen = bsdf.sheen_tint = bsdf.flatness = grey(0.5);
  bsdf.anisotropic = bsdf.spec_tint = grey(0.4);
  return bsdf;
}

strahl::PrincipledThin thin(double roughness, double spec_trans, double diff_trans) {
  strahl::PrincipledThin bsdf;
  bsdf.base_color = {{0.9, 0.6, 0.3}};
  bsdf.roughness = grey(roughness);
  bsdf.spec_trans = grey(spec_trans);
  bsdf.diff_trans = grey(diff_trans);
  bsdf.sheen = bsdf.spec_tint = bsdf.anisotropic = grey(0.4);
  return bsdf;
}

int entry_of(const std::string& name) {
  const std::vector<BsdfEntry> entries = bsdf_entries();
  const auto found =
      std::find_if(entries.begin(), entries.end(), [&](const BsdfEntry& entry) { return entry.name == name; });
  REQUIRE(found != entries.end());
  return static_cast<int>(found - entries.begin());
}

struct Look {
  std::string entry;
  std::vector<double> p;
};

std::vector<Look> looks() {
  strahl::Principled rarely = principled(0.8, 0.1, 0.5, 1);
  rarely.main_specular_sampling_rate = 0.3;
  rarely.clearcoat_sampling_rate = 2;
  rarely.diffuse_reflectance_sampling_rate = 0.5;
  return {
      {"principled", parameters(principled(0.7, 0, 0, 0))},     {"principled", parameters(principled(0.8, 0.5, 0, 1))},
      {"principled", parameters(principled(0.9, 0.2, 0.7, 0))}, {"principled", parameters(rarely)},
      {"principledthin", parameters(thin(0.8, 0.6, 0.7))},      {"principledthin", parameters(thin(0.7, 0.2, 1.6))}};
}

Triad towards(double cosine, double turn) {
  const double sine = std::sqrt((1 - cosine) * (1 + cosine));
  return {sine * std::cos(turn), sine * std::sin(turn), cosine};
}

std::vector<Triad> random_numbers(std::size_t count) {
  std::mt19937_64 engine(17);
  std::vector<Triad> numbers(count);
  for (Triad& triple : numbers) triple = {unit_number(engine), unit_number(engine), unit_number(engine)};
  return numbers;
}

/// The widest of each tier: all widths give the same bits (test_materials.cpp).
std::vector<BsdfTier> widest_tiers() {
  std::vector<BsdfTier> widest;
  for (const BsdfTier& tier : bsdf_tiers()) {
    if (!widest.empty() && std::string(widest.back().name) == tier.name) widest.pop_back();
    widest.push_back(tier);
  }
  return widest;
}

TEST_CASE("directions are drawn as densely as is said, and densities integrate to what is drawn") {
  const std::vector<Triad> numbers = random_numbers(draws_asked(6000));
  for (const Look& look : looks())
    for (const BsdfTier& tier : widest_tiers())
      for (const double cosine : {0.95, 0.5, 0.1, -0.7}) {
        const Triad wo = towards(cosine, 0.7);
        INFO(tier.name << ", " << look.entry << " " << Catch::Detail::stringify(look.p) << ", cosine " << cosine);
        const int kind = entry_of(look.entry);
        const std::vector<Way> ways = tier.sample(kind, look.p, wo, LOBES_ALL, numbers);
        const SphereBins bins = sphere_bins(tier, kind, look.p, wo, ways, 20);
        const auto n = static_cast<double>(ways.size());
        if (bins.others == n)
          CHECK(bins.whole() == 0);
        else
          bins.hold(n);
      }
}

TEST_CASE("finite and of the values told for them, from grazing light to the least roughness") {
  const std::vector<Triad> numbers = random_numbers(256);
  for (const double roughness : {0.0, 0.01, 0.1, 1.0})
    for (const double cosine : {1.0, 0.3, 1e-3, 1e-7, -1e-7, -0.4})
      for (const BsdfTier& tier : widest_tiers()) {
        INFO(tier.name << ", roughness " << roughness << ", cosine " << cosine);
        strahl::Principled bsdf = principled(roughness, 0.3, 0.5, 1);
        bsdf.clearcoat_gloss = grey(1);
        for (const Look& look :
             {Look{"principled", parameters(bsdf)}, Look{"principledthin", parameters(thin(roughness, 0.7, 1))}}) {
          const int kind = entry_of(look.entry);
          int drawn = 0;
          for (const Way& way : tier.sample(kind, look.p, towards(cosine, 2), LOBES_ALL, numbers)) {
            CHECK(std::isfinite(way.density));
            for (const double weight : way.weight) CHECK((std::isfinite(weight) && weight >= 0));
            if (way.density > 0) ++drawn;
          }
          CHECK(drawn > 20);
        }
      }
}

TEST_CASE("principledthin takes a diff_trans above 2, which a texture may give, for 2") {
  const auto kind =
      static_cast<int>(std::find_if(bsdf_entries().begin(), bsdf_entries().end(),
                                    [](const BsdfEntry& entry) { return entry.name == "principledthin"; }) -
                       bsdf_entries().begin());
  const std::vector<double> most = parameters(thin(0.5, 0.2, 2)), more = parameters(thin(0.5, 0.2, 3));
  for (const BsdfTier& tier : bsdf_tiers())
    for (const Triad& wi : {Triad{0, 0.6, 0.8}, Triad{0, 0.6, -0.8}}) {
      INFO(tier.name);
      CHECK(tier.eval(kind, more, {0, 0, 1}, {wi}).front().value ==
            tier.eval(kind, most, {0, 0, 1}, {wi}).front().value);
    }
}

}  // namespace
