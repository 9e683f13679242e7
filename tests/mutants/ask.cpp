// SPDX-License-Identifier: MIT
// The killer of most mutants: the part of `strahl selftest` that is about one tier and one kind of shape, with as few
// questions as still find every mutant. Exit code 7 where the tier does not hold, be it that the canary refuses it.
//
//   mutants_ask TIER KIND [CASES A LAW]
#include <fmt/format.h>

#include <cstdio>
#include <string>

#include "errors.h"
#include "selftest/report.h"
#include "settings/settings.h"

using namespace strahl;

int main(int count, char** arguments) {
  try {
    if (count < 3 || count > 4) throw Error("mutants_ask TIER KIND [CASES]", ExitCode::usage);
    selftest::SelftestOptions options;
    options.tiers = {precision_from_name(arguments[1])};
    options.kinds = {arguments[2]};
    options.cases_per_law = count == 4 ? std::stoi(arguments[3]) : 300;
    options.cases_per_generator = 10;
    const Device device = Device::open("pocl", {options.tiers.front() == Precision::fp64});
    const selftest::SelftestResult result = selftest::run_selftest(device, options);
    fmt::print("{}", selftest::text_of(result));
    const bool holds = result.passed() && result.tiers.front().tier.verdict == Verdict::holds;
    return static_cast<int>(holds ? ExitCode::ok : ExitCode::check_failed);
  } catch (const Error& error) {
    fmt::print(stderr, "{}\n", error.what());
    return static_cast<int>(error.exit_code());
  }
}
