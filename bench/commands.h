// SPDX-License-Identifier: MIT
// strahl-bench's subcommands: each declares its options and returns what runs it.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace strahl::bench {

using Command = std::function<void()>;

Command add_primitives(CLI::App& app);
Command add_traversal(CLI::App& app);
Command add_report(CLI::App& app);
Command add_effects(CLI::App& app);
Command add_scene(CLI::App& app);
Command add_loaders(CLI::App& app);
Command add_mesh(CLI::App& app);

}  // namespace strahl::bench
