// SPDX-License-Identifier: MIT
#include "on_threads.h"

#include <algorithm>
#include <atomic>
#include <future>
#include <thread>
#include <vector>

namespace strahl {

unsigned hardware_threads() { return std::max(std::thread::hardware_concurrency(), 1U); }

void on_threads(std::size_t count, unsigned threads, const std::function<void(std::size_t)>& use) {
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    try {
      for (std::size_t i = next++; i < count; i = next++) use(i);
    } catch (...) {
      next = count;
      throw;
    }
  };
  // Deferred where no thread can be begun: nothing is left by then, and a picture is not lost for want of one.
  constexpr auto beside_if_possible = std::launch::async | std::launch::deferred;
  std::vector<std::future<void>> others;
  for (std::size_t i = 1; i < std::min<std::size_t>(threads, count); ++i)
    others.push_back(std::async(beside_if_possible, work));
  work();
  for (std::future<void>& other : others) other.get();
}

}  // namespace strahl
