// SPDX-License-Identifier: MIT
// strahl's command line: parse, run, and the only place that turns an exception into a message and an exit code.
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>
#include <string>
#include <vector>

#include "cli/app.h"
#include "cli/console.h"
#include "cli/interrupt.h"
#include "cli/process_clock.h"
#include "opencl/cl_code.h"
#include "opencl/opencl.h"
#include "process_memory.h"

namespace {

using strahl::ExitCode;
using strahl::cli::say;

/// One argument as a shell would take it back.
std::string quoted(const std::string& argument) {
  const auto is_plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
           std::string("-_./:=,+@%").find(c) != std::string::npos;
  };
  bool plain = !argument.empty();
  for (const char c : argument) plain = plain && is_plain(c);
  if (plain) return argument;
  std::string text = "'";
  for (const char c : argument) {
    if (c == '\'')
      text += "'\\''";
    else
      text += c;
  }
  return text + "'";
}

ExitCode run(const std::vector<std::string>& arguments, const strahl::cli::Invocation& invocation) {
  try {
    return strahl::cli::run(arguments, invocation);
  } catch (const strahl::SceneError& error) {
    say(error.what());  // Its lines name file, line and column themselves.
    return error.exit_code();
  } catch (const strahl::Error& error) {
    say(std::string("strahl: error: ") + error.what());
    return error.exit_code();
  } catch (const cl::Error& error) {  // By the bindings' own counting of references.
    say(std::string("strahl: error: ") + error.what() + " failed with " + strahl::cl_code_name(error.err()));
  } catch (const std::bad_alloc&) {
    say("strahl: error: out of memory on the host; a smaller picture (--width, --crop), fewer --aov or fewer rays at a "
        "time need less");
  } catch (const std::exception& error) {
    say(std::string("strahl: error: ") + error.what());
  }
  return ExitCode::failure;
}

/// What is to be written has been. A driver's and a compiler's own tidying up takes ten milliseconds that no bill could
/// name any more; only a leak checker needs it.
[[noreturn]] void leave(int code) {
#ifdef __SANITIZE_ADDRESS__
  std::exit(code);
#else
  std::fflush(nullptr);
  std::_Exit(code);
#endif
}

}  // namespace

int main(int argc, char** argv) {
  strahl::begin_with_huge_pages(argv);
  const auto start = strahl::cli::process_start();
  const double main_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  strahl::keep_freed_memory();
  strahl::cli::reserve_standard_streams();
  strahl::cli::set_up_signals();
  const std::vector<std::string> arguments(argv + (argc > 0 ? 1 : 0), argv + argc);
  std::string command_line = "strahl";
  for (const std::string& argument : arguments) command_line += " " + quoted(argument);
  const strahl::ExitCode code = run(arguments, {start, main_seconds, command_line});
  leave(static_cast<int>(code));
}
