// SPDX-License-Identifier: MIT
// cl/materials of every tier and width on the host, side by side; compiled in bsdfs_<tier>.cpp. Directions stand in
// the surface's frame.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "physics/tiers.h"

namespace strahl::test {

/// A line of cl/materials/materials.def.
struct BsdfEntry {
  std::string name;
  int reals;
  int lobes;
};

struct Scattered {
  Triad value;
  double density;
};

struct Way {
  Triad wi, weight;
  double density, eta;
  int lobe;
};

struct BsdfTier {
  const char* name;
  int lanes;
  /// Evaluates the material with number `kind` in the list and the parameters p, for light from each wi towards wo.
  std::vector<Scattered> (*eval)(int kind, const std::vector<double>& p, const Triad& wo, const std::vector<Triad>& wi);
  /// numbers: lobe number, u, v of each way.
  std::vector<Way> (*sample)(int kind, const std::vector<double>& p, const Triad& wo, int lobes,
                             const std::vector<Triad>& numbers);
  /// A parameter at points u, v. Every other point is textured with a checkerboard of red and green; the others are
  /// blue.
  std::vector<Triad> (*parameters)(const std::vector<Triad>& points);
};

/// In the order of the list; `kind` counts in it.
[[nodiscard]] std::vector<BsdfEntry> bsdf_entries();

// stable, robust, double.
[[nodiscard]] std::vector<BsdfTier> bsdf_stable();
[[nodiscard]] std::vector<BsdfTier> bsdf_robust();
[[nodiscard]] std::vector<BsdfTier> bsdf_double();

[[nodiscard]] inline std::vector<BsdfTier> bsdf_tiers() {
  std::vector<BsdfTier> all;
  for (const auto& tiers : {bsdf_stable(), bsdf_robust(), bsdf_double()})
    all.insert(all.end(), tiers.begin(), tiers.end());
  return all;
}

}  // namespace strahl::test
