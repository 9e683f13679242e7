// SPDX-License-Identifier: MIT
// How a device wants its launches: work-items per group, and how many of them it runs at a time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "opencl/device.h"
#include "settings/settings.h"

namespace strahl {

/// What a device allows a kernel.
struct GroupLimits {
  std::string device;  ///< Its name in messages.
  bool is_gpu = false;
  std::uint64_t compute_units = 1;
  std::size_t most = 64;  ///< Work-items of a group.
};

[[nodiscard]] GroupLimits group_limits(const Device& device, const cl::Kernel& kernel);

/// For a kernel of the device. `asked`: the group that the settings name; none: what suits the device.
class LaunchShape {
 public:
  LaunchShape() = default;
  /// lanes: of the kernel's paths. Throws UsageError where the device does not take the group that is asked for.
  LaunchShape(const GroupLimits& limits, int lanes, const std::optional<WorkGroup>& asked);

  /// For a launch of columns x rows work-items. Never of more work-items than the device allows.
  [[nodiscard]] WorkGroup group(int columns, int rows) const;
  /// Launches of fewer take as long as the slowest of their work-items. A CPU runs a few work-items to their end before
  /// it begins others: 1.
  [[nodiscard]] int items_at_once() const { return items_at_once_; }

 private:
  WorkGroup group_;
  WorkGroup row_;  ///< For launches of fewer rows than group_ has.
  bool is_asked_ = false;
  int items_at_once_ = 1;
};

}  // namespace strahl
