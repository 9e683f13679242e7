// SPDX-License-Identifier: MIT
// Ctrl-C, SIGTERM and a closed terminal (SIGHUP) while a picture is rendered: asked for politely the first time, obeyed
// at once the second time.
#pragma once

#include <array>
#include <csignal>

#include "errors.h"

namespace strahl::cli {

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
