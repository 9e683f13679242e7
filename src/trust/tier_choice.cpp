// SPDX-License-Identifier: MIT
// A verdict's file is one of the program cache's: "holds", "degraded" or "refused", the turns after which loops end or
// an empty line, and why.
#include "trust/tier_choice.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <sstream>

#include "opencl/program_cache.h"
#include "program/kernel_files.h"
#include "trust/canary.h"

namespace strahl {
namespace {

/// The default tier, then what stands in for it.
constexpr std::array defaults{Precision::robust, Precision::stable, Precision::fast};

std::string verdict_key(const Device& device, Precision precision) {
  std::uint64_t sources = fnv1a("");
  for (const auto& [path, text] : kernel_files()) sources = fnv1a(text, sources);
  return fmt::format("canary 4 of {}\n{}\nfp64 {}\nkernels {:016x}", precision_name(precision), driver_key(device),
                     device.info().fp64, sources);
}

std::vector<unsigned char> written(const TierVerdict& tier) {
  const std::string turns = tier.loop_turns ? std::to_string(*tier.loop_turns) : "";
  const std::string text = fmt::format("{}\n{}\n{}", verdict_name(tier.verdict), turns, tier.why);
  return {text.begin(), text.end()};
}

std::optional<TierVerdict> read(Precision precision, const std::vector<unsigned char>& bytes) {
  std::istringstream text({bytes.begin(), bytes.end()});
  std::string name, turns, why;
  if (!std::getline(text, name) || !std::getline(text, turns)) return std::nullopt;
  std::getline(text, why);
  std::optional<std::uint64_t> loop_turns;
  if (!turns.empty()) {
    const auto [end, error] = std::from_chars(turns.data(), turns.data() + turns.size(), loop_turns.emplace());
    if (error != std::errc() || end != turns.data() + turns.size()) return std::nullopt;
  }
  for (const Verdict verdict : {Verdict::holds, Verdict::degraded, Verdict::refused})
    if (name == verdict_name(verdict)) return TierVerdict{precision, verdict, why, loop_turns};
  return std::nullopt;
}

}  // namespace

TierVerdict tier_verdict(const Device& device, Precision precision) {
  const std::string name = fmt::format("canary-{}", precision_name(precision)), key = verdict_key(device, precision);
  if (const auto known = read(precision, read_cached_binary(name, key))) return *known;
  TierVerdict tier = run_canary(device, precision).tier;
  write_cached_binary(name, key, written(tier));
  return tier;
}

TierChoice choose_tier(const Device& device, std::optional<Precision> named) {
  if (named) {
    const TierVerdict tier = tier_verdict(device, *named);
    if (tier.verdict != Verdict::refused) return {tier, {}};
    throw NoDeviceError(
        fmt::format("{} cannot keep what precision {} promises: {}; choose another precision or device, or see "
                    "`strahl selftest` for the details",
                    device.info().text(), precision_name(*named), tier.why));
  }
  std::string refusals;
  for (const Precision precision : defaults) {
    const TierVerdict tier = tier_verdict(device, precision);
    if (tier.verdict != Verdict::refused) return {tier, refusals};
    refusals += fmt::format("{}{} is refused: {}", refusals.empty() ? "" : "; ", precision_name(precision), tier.why);
  }
  throw NoDeviceError(fmt::format(
      "{} can be trusted with no precision: {}; choose another device, or see `strahl selftest` for the details",
      device.info().text(), refusals));
}

}  // namespace strahl
