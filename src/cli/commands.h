// SPDX-License-Identifier: MIT
// The subcommands: each file of this folder named after one declares its options and returns what runs it.
#pragma once

#include <chrono>
#include <functional>
#include <string>

#include "errors.h"

namespace CLI {
class App;
}

namespace strahl::cli {

/// One call of the program.
struct Invocation {
  std::chrono::steady_clock::time_point start;  ///< Of the process, as the operating system has it.
  double main_seconds = 0;                      ///< From there to main.
  std::string command_line;                     ///< As typed, quoted for a shell.

  [[nodiscard]] double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }
};

/// Runs after the command line was parsed.
using Command = std::function<ExitCode()>;

Command add_render(CLI::App& app, const Invocation& invocation);
Command add_merge(CLI::App& app, const Invocation& invocation);
Command add_intersect(CLI::App& app, const Invocation& invocation);
Command add_devices(CLI::App& app);
Command add_explain(CLI::App& app);
Command add_compare(CLI::App& app);
Command add_selftest(CLI::App& app);
Command add_stress(CLI::App& app, const Invocation& invocation);
Command add_tradeoff(CLI::App& app, const Invocation& invocation);
Command add_bench(CLI::App& app);

}  // namespace strahl::cli
