// SPDX-License-Identifier: MIT
// How a device wants its launches: work-items per group, and how many of them it runs at a time.
#pragma once

#include "opencl/device.h"
#include "settings/settings.h"

namespace strahl {

/// For a kernel of the device. `asked`: the group that the settings name; none: what suits the device.
class LaunchShape {
 public:
  LaunchShape() = default;
  /// lanes: of the kernel's paths. Throws UsageError where the device does not take the group that is asked for.
  LaunchShape(const Device& device, const cl::Kernel& kernel, int lanes, const std::optional<WorkGroup>& asked);

  /// For a launch of columns x rows work-items.
  [[nodiscard]] WorkGroup group(int columns, int rows) const;
  /// Launches of fewer take as long as the slowest of their work-items. A CPU runs a few work-items to their end before
  /// it begins others: 1.
  [[nodiscard]] int items_at_once() const { return items_at_once_; }

 private:
  WorkGroup group_;
  bool is_asked_ = false;
  int items_at_once_ = 1;
};

}  // namespace strahl
