// SPDX-License-Identifier: MIT
// The command line as a whole: which subcommand runs.
#pragma once

#include <string>
#include <vector>

#include "cli/commands.h"

namespace strahl::cli {

/// arguments: without the program's name. Throws UsageError for what cannot be parsed, and what the subcommand throws.
[[nodiscard]] ExitCode run(std::vector<std::string> arguments, const Invocation& invocation);

}  // namespace strahl::cli
