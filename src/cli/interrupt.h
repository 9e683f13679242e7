// SPDX-License-Identifier: MIT
// Ctrl-C, SIGTERM and a closed terminal (SIGHUP) while a picture is rendered: asked for politely the first time, obeyed
// at once the second time. SIGUSR1 asks for a snapshot. A reader that leaves (SIGPIPE) and a file that grows too large
// (SIGXFSZ) are errors of the call that writes.
#pragma once

#include <array>
#include <csignal>

#include "errors.h"

namespace strahl::cli {

/// Once, before a driver is loaded. Of the signals of InterruptGuard those that the caller ignores (nohup) stay without
/// effect. To ignore them is not enough, for the compiler in a driver (LLVM) has its own handlers for all of them, and
/// for SIGXFSZ too, and they end the process: they are blocked. SIGUSR1 is remembered from here on, also where nothing
/// asks for it. Writing to a pipe that nobody reads fails with EPIPE, beyond the limit of a file's size with EFBIG. A
/// program that a driver starts has SIGPIPE as it was.
void set_up_signals();

/// SIGUSR1 has come since the last snapshot, or since set_up_signals.
[[nodiscard]] bool wants_snapshot();
void snapshot_is_taken();

/// While one lives, the first SIGINT, SIGTERM or SIGHUP is only remembered; the next one ends the process, as it would
/// without this. A signal that the caller ignores (nohup) stays ignored. One at a time.
class InterruptGuard {
 public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

  [[nodiscard]] bool interrupted() const;
  /// ok, interrupted (SIGINT), terminated (SIGTERM) or hung_up (SIGHUP).
  [[nodiscard]] ExitCode exit_code() const;

 private:
  std::array<struct sigaction, 3> old_{};  ///< What each of the signals did before.
};

}  // namespace strahl::cli
