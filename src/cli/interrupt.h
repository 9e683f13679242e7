// SPDX-License-Identifier: MIT
// Ctrl-C and SIGTERM while a picture is rendered: asked for politely the first time, obeyed at once the second time.
#pragma once

#include <csignal>

#include "errors.h"

namespace strahl::cli {

/// While one lives, the first SIGINT or SIGTERM is only remembered; the next one ends the process, as it would without
/// this. A signal that the caller ignores (nohup) stays ignored. One at a time.
class InterruptGuard {
 public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

  [[nodiscard]] bool interrupted() const;
  /// ok, interrupted (SIGINT) or terminated (SIGTERM).
  [[nodiscard]] ExitCode exit_code() const;

 private:
  struct sigaction old_int_ {};
  struct sigaction old_term_ {};
};

}  // namespace strahl::cli
