// SPDX-License-Identifier: MIT
// How much of the film a device holds at a time, and that it is black where a render begins.
#include <algorithm>
#include <catch2/catch.hpp>
#include <chrono>
#include <cstdint>
#include <thread>
#include <vector>

#include "packing/scene_buffers.h"
#include "render/device_film.h"
#include "support/devices.h"

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

TEST_CASE("a film is black up to where it is cleared, however far a thread came before") {
  constexpr std::size_t words = std::size_t{5} << 20, bytes = words * sizeof(std::int64_t), asked_words = words / 4 * 3;
  const std::vector<std::int64_t> used(words, 7);
  std::vector<std::int64_t> now(words);
  for (const std::string& name : present_devices()) {
    const Device device = Device::open(name);
    for (const std::size_t ahead : {std::size_t{0}, bytes / 2, bytes})
      for (const int wait : {0, 100}) {
        INFO(name << ", " << ahead << " bytes ahead, " << wait << " ms");
        const cl::Buffer buffer = allocate(device, bytes, "a film");
        write_buffer(device, buffer, used.data(), bytes);
        FilmBuffer film(device, buffer, ahead);
        std::this_thread::sleep_for(std::chrono::milliseconds(wait));
        for (const bool is_first : {true, false}) {
          film.clear(asked_words * sizeof(std::int64_t));
          read_buffer(device, buffer, now.data(), bytes);
          CHECK(std::all_of(now.begin(), now.begin() + asked_words, [](std::int64_t word) { return word == 0; }));
          if (!is_first) CHECK(now.back() == 7);
          write_buffer(device, buffer, used.data(), bytes);
        }
      }
  }
}

}  // namespace
}  // namespace strahl::test
