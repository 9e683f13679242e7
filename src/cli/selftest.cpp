// SPDX-License-Identifier: MIT
// `strahl selftest`: what every precision is worth on a device.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <limits>
#include <memory>

#include "cli/commands.h"
#include "cli/console.h"
#include "cli/number_options.h"
#include "cli/output_file.h"
#include "cli/progress_bar.h"
#include "cli/scene_options.h"
#include "did_you_mean.h"
#include "program/kernel_source.h"
#include "selftest/faults.h"
#include "selftest/report.h"

namespace strahl::cli {
namespace {

constexpr const char* selftest_footer = R"(
Asks the device millions of questions whose exact answers are known, and says per precision whether its promise holds.

Examples:
  strahl selftest
  strahl selftest -d llvmpipe --tier robust --kind sphere
  strahl selftest --full --json report.json

Exit code 7 where a precision that the device claims, or whose arithmetic is sound, breaks its promise.
docs/selftest.md says what is asked and how to read the table.)";

struct SelftestCommand {
  std::string device;
  std::string json;
  bool full = false;
  bool no_progress = false;
  std::vector<std::string> tiers;
  std::vector<std::string> kinds;
  std::string fault;
  std::uint64_t seed = 1;
};

/// Asked of the kernels only where the command runs: they may be a folder of the user's (STRAHL_KERNEL_DIR).
void require_known(const std::vector<std::string>& kinds) {
  const std::vector<std::string> known = list_entries("shapes");
  for (const std::string& kind : kinds)
    if (std::find(known.begin(), known.end(), kind) == known.end())
      throw UsageError(fmt::format("--kind: \"{}\" is no kind of primitive{}; known: {}", kind,
                                   did_you_mean(kind, known), fmt::join(known, ", ")));
}

/// Each once, where it stands first.
std::vector<std::string> distinct(const std::vector<std::string>& names) {
  std::vector<std::string> once;
  for (const std::string& name : names)
    if (std::find(once.begin(), once.end(), name) == once.end()) once.push_back(name);
  return once;
}

ExitCode run(const SelftestCommand& command) {
  require_known(command.kinds);
  if (!command.json.empty() && command.json != "-") require_writable(command.json);
  selftest::SelftestOptions options;
  if (!command.tiers.empty()) options.tiers.clear();
  for (const std::string& name : distinct(command.tiers)) options.tiers.push_back(precision_from_name(name));
  options.kinds = distinct(command.kinds);
  options.rounds = command.full ? 100 : 1;
  if (command.full) options.cases_per_generator = std::numeric_limits<int>::max();
  options.seed = command.seed;
  options.fault = command.fault;

  const Device device = Device::open(command.device);
  const selftest::SelftestResult result = [&] {
    ProgressBar bar("selftest", !command.no_progress);
    return selftest::run_selftest(device, options,
                                  [&](double share, const std::string& what) { bar.show(share, what); });
  }();
  if (command.json == "-")
    print(selftest::json_of(result));
  else
    print(selftest::text_of(result));
  if (!command.json.empty() && command.json != "-") write_text(command.json, selftest::json_of(result));
  return result.passed() ? ExitCode::ok : ExitCode::check_failed;
}

}  // namespace

Command add_selftest(CLI::App& app) {
  const auto command = std::make_shared<SelftestCommand>();
  add_device_option(app, command->device);
  app.add_flag("--full", command->full, "A hundred times as many questions: minutes");
  app.add_option("--json", command->json, "Everything for programs; - for standard output, in place of the table")
      ->type_name("FILE");
  app.add_option("--tier", command->tiers, "Only this precision; repeatable")
      ->type_name("NAME")
      ->allow_extra_args(false)
      ->check(CLI::IsMember({"fast", "stable", "robust", "double"}));
  app.add_option("--kind", command->kinds, "Only this kind of primitive: sphere, triangle, ...; repeatable")
      ->type_name("NAME")
      ->allow_extra_args(false);
  require_whole(app.add_option("--seed", command->seed, "Of the questions"))
      ->type_name("N")
      ->capture_default_str()
      ->check(CLI::Range(std::int64_t{0}, std::numeric_limits<std::int64_t>::max()).description(""));
  app.add_flag("--no-progress", command->no_progress, "No progress bar");
  std::vector<std::string> faults;
  std::string what = "Try the self test: make the device wrong. ";
  for (const selftest::FaultName& fault : selftest::fault_names()) {
    faults.push_back(fault.name);
    what += fmt::format("{}{}: {}", faults.size() == 1 ? "" : "; ", fault.name, fault.what);
  }
  app.add_option("--inject", command->fault, what)->type_name("FAULT")->check(CLI::IsMember(faults).description(""));
  app.footer(selftest_footer);
  return [command] { return run(*command); };
}

}  // namespace strahl::cli
