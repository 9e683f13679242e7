// SPDX-License-Identifier: MIT
// The table has no room for what the canary only records; the JSON has.
#include "selftest/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "json_text.h"

namespace strahl::selftest {
namespace {

using Json = nlohmann::ordered_json;

/// Four characters or few more: 0.50, 12.3, 5.1e+03.
std::string short_number(double x) {
  if (!std::isfinite(x)) return "-";
  return x >= 1000 ? fmt::format("{:.1e}", x) : x >= 10 ? fmt::format("{:.1f}", x) : fmt::format("{:.2f}", x);
}

std::string share(std::size_t wrong, std::size_t cases) {
  return cases == 0 ? "-" : fmt::format("{}/{}", wrong, cases);
}

std::string verdict_text(const TierVerdict& tier) {
  return fmt::format("{:<7} {}{}", precision_name(tier.precision), verdict_name(tier.verdict),
                     tier.why.empty() ? "" : ": " + tier.why);
}

Json tally_json(const Tally& tally) {
  return {{"cases", tally.cases},
          {"wrong", tally.wrong},
          {"nan", tally.nans},
          {"max_ulp", tally.max_ulps()},
          {"p99_ulp", tally.p99_ulps()},
          {"first_wrong", tally.first_wrong.empty() ? Json(nullptr) : Json(tally.first_wrong)}};
}

Json canary_json(const CanaryReport& canary) {
  Json findings = Json::array();
  for (const CanaryFinding& found : canary.findings)
    findings.push_back({{"property", found.property},
                        {"cases", found.cases},
                        {"wrong", found.wrong},
                        {"verdict", verdict_name(found.verdict)},
                        {"detail", found.detail.empty() ? Json(nullptr) : Json(found.detail)}});
  return {{"verdict", verdict_name(canary.tier.verdict)},
          {"why", canary.tier.why.empty() ? Json(nullptr) : Json(canary.tier.why)},
          {"findings", findings}};
}

/// Properties that are not there, once for all tiers that say the same.
std::string canary_text(const SelftestResult& result) {
  std::string text = "canary\n";
  for (const TierResult& tier : result.tiers) text += "  " + verdict_text(tier.canary.tier) + "\n";
  std::vector<std::string> said;
  for (const TierResult& tier : result.tiers)
    for (const CanaryFinding& found : tier.canary.findings) {
      if (found.verdict == Verdict::holds || std::find(said.begin(), said.end(), found.detail) != said.end()) continue;
      said.push_back(found.detail);
      text += fmt::format("    {}: {} of {}; {}\n", found.property, found.wrong, found.cases, found.detail);
    }
  return text;
}

}  // namespace

std::string text_of(const SelftestResult& result) {
  std::string text =
      fmt::format("{} · seed {} · {} cases a law\n\n{}\n", result.device, result.options.seed,
                  result.options.cases_per_law * std::max(1, result.options.rounds), canary_text(result));
  text += fmt::format("{:<7} {:<13} {:>9} {:>7} {:>8} {:>8} {:>5} {:>8} {:>10} {:>10} {:>10}\n", "tier", "primitive",
                      "cases", "wrong", "max ulp", "p99 ulp", "NaN", "ns/test", "catalogue", "seams", "respawn");
  for (const TierResult& tier : result.tiers)
    for (const Line& line : result.lines)
      if (line.precision == tier.tier.precision)
        text += fmt::format("{:<7} {:<13} {:>9} {:>7} {:>8} {:>8} {:>5} {:>8} {:>10} {:>10} {:>10}\n",
                            precision_name(line.precision), line.kind, line.laws.cases, line.laws.wrong,
                            short_number(line.laws.max_ulps()), short_number(line.laws.p99_ulps()),
                            line.laws.nans + line.catalogue.nans + line.respawn.nans,
                            short_number(line.nanoseconds_per_test), share(line.catalogue.wrong, line.catalogue.cases),
                            share(line.seams.wrong(), line.seams.rays), share(line.respawn.wrong, line.respawn.cases));
  text += "\nverdict\n";
  for (const TierResult& tier : result.tiers) {
    text += "  " + verdict_text(tier.tier) + (tier.is_failed ? " (FAILED)" : "") + "\n";
    for (const std::string& promise : tier.broken) text += "    " + promise + "\n";
  }
  return text + fmt::format("\n{:.1f} s\n", result.seconds);
}

std::string json_of(const SelftestResult& result) {
  Json tiers = Json::array(), lines = Json::array();
  for (const TierResult& tier : result.tiers)
    tiers.push_back({{"precision", precision_name(tier.tier.precision)},
                     {"verdict", verdict_name(tier.tier.verdict)},
                     {"why", tier.tier.why.empty() ? Json(nullptr) : Json(tier.tier.why)},
                     {"failed", tier.is_failed},
                     {"broken", tier.broken},
                     {"canary", canary_json(tier.canary)}});
  for (const Line& line : result.lines)
    lines.push_back(
        {{"precision", precision_name(line.precision)},
         {"primitive", line.kind},
         {"laws", tally_json(line.laws)},
         {"catalogue", tally_json(line.catalogue)},
         {"respawn", tally_json(line.respawn)},
         {"seams", {{"rays", line.seams.rays}, {"leaks", line.seams.leaks}, {"doubles", line.seams.doubles}}},
         {"ns_per_test", line.nanoseconds_per_test}});
  const Json json{{"device", result.device},
                  {"version", STRAHL_VERSION},
                  {"seed", result.options.seed},
                  {"cases_per_law", result.options.cases_per_law * std::max(1, result.options.rounds)},
                  {"passed", result.passed()},
                  {"tiers", tiers},
                  {"lines", lines},
                  {"seconds", result.seconds}};
  return json_text(json);
}

}  // namespace strahl::selftest
