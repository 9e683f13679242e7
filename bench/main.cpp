// SPDX-License-Identifier: MIT
// strahl-bench: bench/README.md.
#include <fmt/format.h>

#include <cstdio>

#include "bench/commands.h"
#include "errors.h"
#include "process_memory.h"

using namespace strahl;

int main(int argc, char** argv) {
  begin_with_huge_pages(argv);
  keep_freed_memory();
  CLI::App app{"Times that are believed only where the answers are right", "strahl-bench"};
  app.require_subcommand(1);
  std::vector<std::pair<const CLI::App*, bench::Command>> commands;
  const auto add = [&](const char* name, const char* description, bench::Command (*declare)(CLI::App&)) {
    CLI::App* sub = app.add_subcommand(name, description);
    commands.emplace_back(sub, declare(*sub));
  };
  add("primitives", "What each tier costs a primitive: brute force", bench::add_primitives);
  add("traversal", "Rays through scenes: scene x rays x tier, against the peers that are there", bench::add_traversal);
  add("report", "Tables and plots of earlier measurements of traversal", bench::add_report);
  add("effects", "Specialised programs beside the generic one, and beside a kernel written by hand",
      bench::add_effects);
  add("scene", "Write a generated scene for strahl and for other programs", bench::add_scene);
  add("loaders", "How fast mesh files are read", bench::add_loaders);
  add("mesh", "Write a mesh file of any size", bench::add_mesh);
  CLI11_PARSE(app, argc, argv);
  try {
    for (const auto& [sub, command] : commands)
      if (sub->parsed()) command();
  } catch (const Error& error) {
    fmt::print(stderr, "strahl-bench: {}\n", error.what());
    return static_cast<int>(error.exit_code());
  } catch (const std::exception& error) {
    fmt::print(stderr, "strahl-bench: {}\n", error.what());
    return 1;
  }
  return 0;
}
