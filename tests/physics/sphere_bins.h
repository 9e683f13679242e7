// SPDX-License-Identifier: MIT
// What a material draws, against its stated density, in 8 x 8 bins of equal solid angle over the whole sphere.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "physics/bsdf_tiers.h"
#include "physics/statistics.h"

namespace strahl::test {

/// Draws with one wo. `others` are those in no direction: by delta lobes, or absorbed.
struct SphereBins {
  std::vector<double> hits, shares;  ///< A number a bin: of draws, and by the density.
  double others = 0;

  /// The density's integral.
  [[nodiscard]] double whole() const { return std::accumulate(shares.begin(), shares.end(), 0.0); }

  /// numbers: how many there are.
  void hold(double numbers) const {
    const double share = others / numbers;
    CHECK(whole() + share == Approx(1).margin(5e-3 + 4 * std::sqrt(share * (1 - share) / numbers)));
    std::vector<double> expected = shares;
    for (double& bin : expected) bin *= numbers;
    hold_counts(hits, expected);
  }
};

/// Of a bin: where it begins, and how far it goes.
struct Part {
  std::size_t bin;
  double z, phi, height, turn;
  double share = 0;
};

inline void find_shares(const BsdfTier& tier, int kind, const std::vector<double>& p, const Triad& wo,
                        std::vector<Part>& parts) {
  std::vector<Triad> middles;
  for (const Part& part : parts) {
    const double z = part.z + part.height / 2, phi = part.phi + part.turn / 2, r = std::sqrt((1 - z) * (1 + z));
    middles.push_back({r * std::cos(phi), r * std::sin(phi), z});
  }
  const std::vector<Scattered> found = tier.eval(kind, p, wo, middles);
  for (std::size_t k = 0; k < parts.size(); ++k) parts[k].share = found[k].density * parts[k].height * parts[k].turn;
}

inline std::vector<Part> quartered(const std::vector<Part>& parts) {
  std::vector<Part> quarters;
  for (const auto& [bin, z, phi, height, turn, share] : parts)
    for (const double up : {0.0, height / 2})
      for (const double on : {0.0, turn / 2}) quarters.push_back({bin, z + up, phi + on, height / 2, turn / 2});
  return quarters;
}

/// within: parts of a bin to begin with, in either direction. They are quartered until it changes next to nothing:
/// where all normals are drawn and light is grazing, the density has a pole.
[[nodiscard]] inline SphereBins sphere_bins(const BsdfTier& tier, int kind, const std::vector<double>& p,
                                            const Triad& wo, const std::vector<Way>& ways, int within) {
  constexpr int rings = 8, sectors = 8, levels = 10;
  constexpr double change = 3e-7;
  SphereBins bins{std::vector<double>(rings * sectors, 0), std::vector<double>(rings * sectors, 0)};
  for (const Way& way : ways) {
    if ((way.lobe & lobes::LOBE_DELTA) != 0 || way.density == 0) {
      bins.others += 1;
      continue;
    }
    const double turn = std::atan2(way.wi[1], way.wi[0]) / (2 * std::numbers::pi);
    const int ring = std::min(static_cast<int>((0.5 + 0.5 * way.wi[2]) * rings), rings - 1);
    const int sector = static_cast<int>((turn + 1) * sectors) % sectors;
    bins.hits.at(static_cast<std::size_t>(ring * sectors + sector)) += 1;
  }
  const double height = 2.0 / (rings * within), turn = 2 * std::numbers::pi / (sectors * within);
  std::vector<Part> open;
  for (int i = 0; i < rings * within; ++i)
    for (int j = 0; j < sectors * within; ++j)
      open.push_back(
          {static_cast<std::size_t>(i / within * sectors + j / within), i * height - 1, j * turn, height, turn});
  find_shares(tier, kind, p, wo, open);
  for (int level = 1; !open.empty(); ++level) {
    std::vector<Part> quarters = quartered(open), next;
    find_shares(tier, kind, p, wo, quarters);
    for (std::size_t k = 0; k < open.size(); ++k) {
      const auto first = quarters.begin() + static_cast<std::ptrdiff_t>(4 * k);
      const double sum =
          std::accumulate(first, first + 4, 0.0, [](double all, const Part& part) { return all + part.share; });
      if (level < levels && std::fabs(sum - open[k].share) > change)
        next.insert(next.end(), first, first + 4);
      else
        bins.shares[open[k].bin] += sum;
    }
    open = std::move(next);
  }
  return bins;
}

}  // namespace strahl::test
