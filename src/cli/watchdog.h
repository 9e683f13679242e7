// SPDX-License-Identifier: MIT
// Ends the process where the device does not come back: a driver that hangs cannot be asked to stop.
#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

namespace strahl::cli {

/// Of launches alone: while the host works, or programs are built, it is to rest. It begins so. After fed(), another
/// fed() or rest() must come within `seconds`; else what happened is said, and the process ends with exit code 1 at
/// once, with its files as they are. what_is_kept: what is said then of the samples so far; asked by another
/// thread. 0 s: does nothing.
class Watchdog {
 public:
  Watchdog(double seconds, std::function<std::string()> what_is_kept);
  ~Watchdog();
  Watchdog(const Watchdog&) = delete;
  Watchdog& operator=(const Watchdog&) = delete;

  void fed();
  /// Until it is fed again.
  void rest();

 private:
  void heed(bool is_resting);
  void watch();

  double seconds_;
  std::function<std::string()> what_is_kept_;
  std::mutex mutex_;  ///< Of all below.
  std::condition_variable wake_;
  bool has_news_ = false, is_resting_ = true, is_over_ = false;
  std::thread thread_;
};

}  // namespace strahl::cli
