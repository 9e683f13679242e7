// SPDX-License-Identifier: MIT
#include "cli/watchdog.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <utility>

#include "cli/console.h"
#include "errors.h"

namespace strahl::cli {

Watchdog::Watchdog(double seconds, std::function<std::string()> what_is_kept)
    : seconds_(seconds), what_is_kept_(std::move(what_is_kept)) {
  if (seconds_ > 0) thread_ = std::thread([this] { watch(); });
}

Watchdog::~Watchdog() {
  {
    const std::scoped_lock lock(mutex_);
    is_over_ = true;
  }
  wake_.notify_one();
  if (thread_.joinable()) thread_.join();
}

void Watchdog::fed() {
  if (seconds_ <= 0) return;
  {
    const std::scoped_lock lock(mutex_);
    is_fed_ = true;
  }
  wake_.notify_one();
}

void Watchdog::watch() {
  std::unique_lock lock(mutex_);
  const std::chrono::duration<double> patience(std::min(seconds_, 1e9));
  while (wake_.wait_for(lock, patience, [this] { return is_fed_ || is_over_; })) {
    if (is_over_) return;
    is_fed_ = false;
  }
  say(fmt::format("strahl: error: the device has not come back from a launch for {:.6g} s (--watchdog); {}", seconds_,
                  what_is_kept_()));
  std::_Exit(static_cast<int>(ExitCode::failure));
}

}  // namespace strahl::cli
