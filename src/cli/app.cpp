// SPDX-License-Identifier: MIT
// The command line as a whole: `render` is the subcommand where the first argument is a file; mistyped subcommands and
// options are answered with the nearest known ones.
#include "cli/app.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <sstream>

#include "cli/console.h"
#include "did_you_mean.h"
#include "opencl/program.h"

namespace strahl::cli {
namespace {

constexpr const char* app_footer = R"(
The first argument may be a scene or a mesh instead of a subcommand: it is rendered.

Examples:
  strahl scenes/lecture/first-light.xml -o first-light.png
  strahl render mesh.obj --width 512 --spp 64 --aov depth,normal -o mesh.exr
  strahl explain scenes/lecture/lit.xml
  strahl devices
  strahl selftest

Exit codes:
  0  ok                           5  a kernel does not build
  1  failure                      6  target missed
  2  wrong usage                  7  comparison or self test failed
  3  scene or input unusable      129, 130, 143  hung up, interrupted (Ctrl-C), terminated;
  4  no suitable OpenCL device                   the picture so far is written

`strahl COMMAND --help` lists a command's options.)";

/// `strahl scene.xml` means `strahl render scene.xml`; a word that is neither command nor file is a typing error.
void insert_default_command(std::vector<std::string>& arguments, const std::vector<std::string>& commands) {
  const std::string& first = arguments.front();
  const auto is = [&](const auto& known) { return std::find(known.begin(), known.end(), first) != known.end(); };
  if (is(commands) || is(std::vector<std::string>{"-h", "--help", "--version"})) return;
  std::error_code ignored;
  // The link itself: where it leads nowhere, `render` says why.
  const bool looks_like_a_file = first.find_first_of("./") != std::string::npos ||
                                 std::filesystem::exists(std::filesystem::symlink_status(first, ignored));
  if (!first.starts_with('-') && !looks_like_a_file)
    throw UsageError(fmt::format("\"{}\" is neither a command nor a file{}; commands: {}", first,
                                 did_you_mean(first, commands), fmt::join(commands, ", ")));
  arguments.insert(arguments.begin(), "render");
}

/// What CLI11 found wrong, with the nearest option's name where one was mistyped, and where help is.
UsageError usage_error(const CLI::ParseError& error, const CLI::App& app) {
  const std::vector<CLI::App*> parsed = app.get_subcommands();
  const CLI::App& command = parsed.empty() ? app : *parsed.front();
  std::string hint;
  if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr) {
    std::vector<std::string> known;
    for (const CLI::Option* option : command.get_options())
      for (const std::string& name : option->get_lnames()) known.push_back("--" + name);
    for (const std::string& extra : command.remaining()) {
      const std::string name = extra.substr(0, extra.find('='));
      if (name.starts_with("--")) hint += did_you_mean(name, known);
    }
  }
  return UsageError(fmt::format("{}{}\nstrahl: `strahl {}--help` shows what is possible", error.what(), hint,
                                parsed.empty() ? "" : command.get_name() + " "));
}

/// An empty value is most often a script's variable that is not set: not the same as an option that is not given.
void refuse_empty_values(CLI::App& command) {
  const auto fault = [](const std::string& value) { return std::string(value.empty() ? "must not be empty" : ""); };
  for (CLI::Option* option : command.get_options())
    if (option->get_items_expected_min() > 0) option->check(fault, "");
}

/// Of an option whose value may be left out, CLI11 takes whatever word comes next for it, the scene too. Here the next
/// word is the value where it is one of those that the option knows; otherwise the option's default is.
void bind_optional_values(std::vector<std::string>& arguments, CLI::App& command) {
  for (std::size_t i = 1; i < arguments.size() && arguments[i] != "--"; ++i) {
    if (!arguments[i].starts_with("--")) continue;
    CLI::Option* option = command.get_option_no_throw(arguments[i]);
    if (option == nullptr || option->get_items_expected_min() != 0 || option->get_items_expected_max() != 1) continue;
    std::string value = option->get_default_str();
    if (i + 1 < arguments.size() && (*option->get_validator(0))(arguments[i + 1]).empty()) {
      value = arguments[i + 1];
      arguments.erase(arguments.begin() + static_cast<std::ptrdiff_t>(i) + 1);
    }
    arguments[i] += "=" + value;
  }
}

}  // namespace

ExitCode run(std::vector<std::string> arguments, const Invocation& invocation) {
  CLI::App app{"strahl: a ray tracer for any OpenCL device", "strahl"};
  app.set_version_flag("--version", "strahl " STRAHL_VERSION, "Print the version and exit");
  app.set_help_flag("-h,--help", "Print this help and exit");
  app.get_formatter()->column_width(34);
  app.footer(app_footer);
  app.require_subcommand(1);
  // As everywhere: of an option that takes one value and is given twice, the last holds, so that a script's own can be
  // overridden at the end of its line. Subcommands inherit it; lists keep all of their values.
  app.option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);

  std::vector<std::string> names;
  std::vector<std::pair<CLI::App*, Command>> commands;
  const auto add = [&](const char* name, const char* description, const auto& declare) {
    CLI::App* sub = app.add_subcommand(name, description);
    commands.emplace_back(sub, declare(*sub));
    refuse_empty_values(*sub);
    names.emplace_back(name);
  };
  add("render", "Render a scene or a mesh to a picture", [&](CLI::App& sub) { return add_render(sub, invocation); });
  add("merge", "Add up parts of a picture's samples", [&](CLI::App& sub) { return add_merge(sub, invocation); });
  add("intersect", "Trace rays of a NumPy file, write where they hit",
      [&](CLI::App& sub) { return add_intersect(sub, invocation); });
  add("devices", "List OpenCL platforms and devices", add_devices);
  add("explain", "Say which effects a scene calls for, and where", add_explain);
  add("compare", "Measure how far one picture is from another", add_compare);
  add("selftest", "Ask a device how far its arithmetic can be trusted", add_selftest);
  add("stress", "Show a scene in other units and elsewhere, in every precision",
      [&](CLI::App& sub) { return add_stress(sub, invocation); });
  add("tradeoff", "Measure what error costs in time: precision, samples, depth, sampler",
      [&](CLI::App& sub) { return add_tradeoff(sub, invocation); });
  add("bench", "Measure how fast a device is", add_bench);

  if (arguments.empty()) throw UsageError("nothing to do: name a scene or a command; `strahl --help` shows which");
  insert_default_command(arguments, names);
  for (const auto& [command, run_it] : commands)
    if (command->get_name() == arguments.front()) bind_optional_values(arguments, *command);
  try {
    std::reverse(arguments.begin(), arguments.end());  // CLI11 takes them from the back.
    app.parse(arguments);
  } catch (const CLI::Success& success) {  // --help, --version
    std::ostringstream text;
    app.exit(success, text, text);
    print(text.str());
    return ExitCode::ok;
  } catch (const CLI::ParseError& error) {
    throw usage_error(error, app);
  }
  const auto chosen =
      std::find_if(commands.begin(), commands.end(), [](const auto& command) { return command.first->parsed(); });
  for (const std::string& fault : {program_cache_fault(), program_cache_size_fault()})
    if (!fault.empty()) say("strahl: warning: " + fault);
  return chosen->second();
}

}  // namespace strahl::cli
