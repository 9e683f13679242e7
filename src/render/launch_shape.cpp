// SPDX-License-Identifier: MIT
#include "render/launch_shape.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>

#include "errors.h"
#include "opencl/cl_code.h"

namespace strahl {
namespace {

/// GPUs run the work-items of a group in lockstep, some 32 at a time: rays of a square of pixels are more alike than
/// those of a row (measured in docs/decisions/0034-gpus.md).
constexpr WorkGroup square{8, 8};

/// A CPU's threads take groups in chunks, of PoCL half of those that are left: with work-items that fill the
/// processor's lanes by themselves, groups of a few share a launch more evenly, and where a launch has few work-items,
/// groups of one (measured in docs/decisions/0026-path-pool.md).
constexpr WorkGroup short_row{4, 1};
constexpr int few_items = 2048;

}  // namespace

GroupLimits group_limits(const Device& device, const cl::Kernel& kernel) {
  const DeviceInfo& info = device.info();
  const std::size_t most =
      checked(info.text(), [&] { return kernel.getWorkGroupInfo<CL_KERNEL_WORK_GROUP_SIZE>(device.device()); });
  return {info.text(), info.type == "GPU", info.compute_units, most};
}

LaunchShape::LaunchShape(const GroupLimits& limits, int lanes, const std::optional<WorkGroup>& asked)
    : group_(asked.value_or(lanes > 1 ? short_row : WorkGroup{})), is_asked_(asked.has_value()) {
  const std::size_t most = std::max<std::size_t>(limits.most, 1);
  const std::size_t items = static_cast<std::size_t>(group_.x) * static_cast<std::size_t>(group_.y);
  if (is_asked_ && (group_.x < 1 || group_.y < 1 || items > most))
    throw UsageError(
        fmt::format("--work-group {}x{}: {} allows 1 to {} work-items", group_.x, group_.y, limits.device, most));
  row_.x = static_cast<int>(std::bit_floor(std::min(most, static_cast<std::size_t>(row_.x))));
  if (!is_asked_ && items > most) group_ = row_;
  if (!limits.is_gpu) return;
  items_at_once_ =
      static_cast<int>(std::min<std::uint64_t>(limits.compute_units * most, std::numeric_limits<int>::max()));
  if (!is_asked_ && most >= static_cast<std::size_t>(square.x) * square.y) group_ = square;
}

WorkGroup LaunchShape::group(int columns, int rows) const {
  if (is_asked_) return group_;
  if (group_.x == short_row.x && static_cast<std::int64_t>(columns) * rows < few_items) return {1, 1};
  return rows >= group_.y ? group_ : row_;
}

}  // namespace strahl
