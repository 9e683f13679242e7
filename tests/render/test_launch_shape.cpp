// SPDX-License-Identifier: MIT
// LaunchShape never asks for larger groups than the device allows its kernel.
#include <catch2/catch.hpp>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "errors.h"
#include "render/launch_shape.h"

namespace strahl::test {
namespace {

std::size_t items(const WorkGroup& group) {
  return static_cast<std::size_t>(group.x) * static_cast<std::size_t>(group.y);
}

std::pair<int, int> size(const WorkGroup& group) { return {group.x, group.y}; }

// A renderer's first launches, which warm up the device, have one column and no row.
TEST_CASE("no group is larger than the device allows, however few rows a launch has") {
  for (const bool is_gpu : {false, true})
    for (const int lanes : {1, 8})
      for (const std::size_t most : {1, 2, 3, 8, 32, 63, 64, 100, 1024}) {
        const LaunchShape shape({"a device", is_gpu, 4, most}, lanes, {});
        for (const auto& [columns, rows] : {std::pair(1, 0), {1, 1}, {100, 1}, {100, 7}, {100, 8}, {1000, 1000}}) {
          INFO((is_gpu ? "GPU" : "CPU") << ", " << lanes << " lanes, at most " << most << ", launch of " << columns
                                        << " x " << rows);
          CHECK(items(shape.group(columns, rows)) >= 1);
          CHECK(items(shape.group(columns, rows)) <= most);
        }
      }
}

TEST_CASE("devices that allow 64 have squares on GPUs, rows where a launch has few") {
  const LaunchShape gpu({"a device", true, 4, 1024}, 1, {}), cpu({"a device", false, 4, 1024}, 1, {});
  CHECK(size(gpu.group(100, 100)) == std::pair(8, 8));
  CHECK(size(gpu.group(100, 7)) == std::pair(64, 1));
  CHECK(size(cpu.group(100, 100)) == std::pair(64, 1));
  CHECK(gpu.items_at_once() == 4096);
  CHECK(cpu.items_at_once() == 1);
}

TEST_CASE("a group that is asked for is taken or refused") {
  const GroupLimits limits{"a device", false, 4, 32};
  CHECK(size(LaunchShape(limits, 1, WorkGroup{8, 4}).group(1, 0)) == std::pair(8, 4));
  CHECK_THROWS_AS(LaunchShape(limits, 1, WorkGroup{8, 8}), UsageError);
}

}  // namespace
}  // namespace strahl::test
