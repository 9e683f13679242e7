// SPDX-License-Identifier: MIT
// How much of the film a device holds at a time.
#include <catch2/catch.hpp>

#include "render/device_film.h"

namespace strahl::test {
namespace {

constexpr std::size_t gibibyte = std::size_t{1} << 30;

DeviceInfo device(bool shares_host_memory, std::size_t max_allocation) {
  DeviceInfo info;
  info.shares_host_memory = shares_host_memory;
  info.max_allocation = max_allocation;
  return info;
}

TEST_CASE("the film is held as a whole where it lies in the host's memory") {
  CHECK(largest_film_buffer(device(true, 6 * gibibyte), false) == 6 * gibibyte);
  CHECK(largest_film_buffer(device(true, 6 * gibibyte), true) == gibibyte / 2);
  for (const bool is_helper : {false, true}) {
    CHECK(largest_film_buffer(device(false, 6 * gibibyte), is_helper) == gibibyte / 2);
    for (const bool shares : {false, true}) CHECK(largest_film_buffer(device(shares, 1024), is_helper) == 1024);
  }
}

}  // namespace
}  // namespace strahl::test
