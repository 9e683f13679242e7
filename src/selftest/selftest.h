// SPDX-License-Identifier: MIT
// What every tier of precision is worth on a device, against exact answers: `strahl selftest`.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "selftest/seams.h"
#include "selftest/tally.h"
#include "trust/canary.h"

namespace strahl::selftest {

struct SelftestOptions {
  std::vector<Precision> tiers{Precision::fast, Precision::stable, Precision::robust, Precision::fp64};
  std::vector<std::string> kinds;  ///< Of cl/shapes/shapes.def; empty: all.
  int cases_per_law = 2000;        ///< Of each of the laws of oracle/generators.h.
  int cases_per_generator = 50;    ///< Of the catalogue's.
  int rounds = 1;                  ///< So many times that, with other seeds.
  std::uint64_t seed = 1;
  std::string fault;  ///< selftest/faults.h; empty: none.
};

/// A tier and a kind of primitive.
struct Line {
  Precision precision = Precision::stable;
  std::string kind;
  Tally laws;       ///< All that the oracle decides; in 32 bits without the law `extreme`, which leaves their range.
  Tally catalogue;  ///< selftest/catalogue.h
  Tally respawn;    ///< Rays that leave what they have hit.
  Seams seams;      ///< Triangles and parallelograms only.
  double nanoseconds_per_test = 0;
};

struct TierResult {
  CanaryReport canary;
  std::vector<std::string> broken;  ///< Promises, a sentence each.
  TierVerdict tier;                 ///< The canary's, or refused where a promise is broken.
  bool is_failed = false;           ///< The device claims the tier, or its canary passed it, but it does not hold.
};

struct SelftestResult {
  std::string device;
  SelftestOptions options;
  std::vector<TierResult> tiers;
  std::vector<Line> lines;  ///< Of the tiers that the canary has not refused.
  double seconds = 0;

  [[nodiscard]] bool passed() const;
};

/// share: of the work that is done, 0 to 1; what: that is being done.
using Step = std::function<void(double share, const std::string& what)>;

[[nodiscard]] SelftestResult run_selftest(const Device& device, const SelftestOptions& options, const Step& step = {});

}  // namespace strahl::selftest
