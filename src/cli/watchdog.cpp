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

void Watchdog::fed() { heed(false); }
void Watchdog::rest() { heed(true); }

void Watchdog::heed(bool is_resting) {
  if (seconds_ <= 0) return;
  {
    const std::scoped_lock lock(mutex_);
    has_news_ = true;
    is_resting_ = is_resting;
  }
  wake_.notify_one();
}

void Watchdog::watch() {
  std::unique_lock lock(mutex_);
  const std::chrono::duration<double> patience(std::min(seconds_, 1e9));
  const auto has_news = [this] { return has_news_ || is_over_; };
  while (is_resting_ || wake_.wait_for(lock, patience, has_news)) {
    if (is_resting_) wake_.wait(lock, [this] { return !is_resting_ || is_over_; });
    if (is_over_) return;
    has_news_ = false;
  }
  say(fmt::format("strahl: error: the device has not come back from a launch for {:.6g} s (--watchdog); {}", seconds_,
                  what_is_kept_()));
  std::_Exit(static_cast<int>(ExitCode::failure));
}

}  // namespace strahl::cli
