// SPDX-License-Identifier: MIT
// Work that threads share: all of it once, and faults reach the caller.
#include <algorithm>
#include <array>
#include <atomic>
#include <catch2/catch.hpp>
#include <stdexcept>

#include "on_threads.h"

namespace strahl::test {

TEST_CASE("each number is used once, on however many threads") {
  for (const unsigned threads : {1U, 2U, 8U}) {
    std::array<std::atomic<int>, 100> used{};
    on_threads(used.size(), threads, [&](std::size_t i) { ++used[i]; });
    CHECK(std::all_of(used.begin(), used.end(), [](const std::atomic<int>& times) { return times == 1; }));
  }
  on_threads(0, 2, [](std::size_t) { FAIL(); });
}

TEST_CASE("what fails in a thread is thrown, and those not begun are left out") {
  for (const unsigned threads : {1U, 2U, 8U}) {
    std::atomic<int> used = 0;
    CHECK_THROWS_AS(on_threads(100000, threads,
                               [&](std::size_t) {
                                 ++used;
                                 throw std::runtime_error("no");
                               }),
                    std::runtime_error);
    CHECK(used <= static_cast<int>(threads));
  }
}

}  // namespace strahl::test
