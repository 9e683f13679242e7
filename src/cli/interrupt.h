// SPDX-License-Identifier: MIT
// Ctrl-C, SIGTERM and a closed terminal (SIGHUP) while a picture is rendered: asked for politely the first time, obeyed
// at once the second time. SIGUSR1 asks for a snapshot.
#pragma once

#include <array>
#include <csignal>

#include "errors.h"

namespace strahl::cli {

/// Once, before a driver is loaded: of the signals of InterruptGuard those that the caller ignores (nohup) stay without
/// effect. To ignore them is not enough, for the compiler in a driver (LLVM) has its own handlers for all of them, and
/// they end the process.
void block_ignored_signals();

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
  /// SIGUSR1 has come since the last snapshot.
  [[nodiscard]] bool wants_snapshot() const;
  void snapshot_is_taken();

 private:
  std::array<struct sigaction, 3> old_{};  ///< What each of the signals did before.
  struct sigaction old_snapshot_ {};
};

}  // namespace strahl::cli
