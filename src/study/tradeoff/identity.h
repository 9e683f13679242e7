// SPDX-License-Identifier: MIT
// What a measured point depends on besides its own setting: as long as it is the same, an earlier run's points hold.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "opencl/device.h"
#include "study/tradeoff/setting.h"

namespace strahl {

/// Each with what it is called in a message: "scene", "device", "seeds" ...
struct StudyIdentity {
  std::vector<std::pair<std::string, std::string>> parts;

  [[nodiscard]] std::string hash() const;  ///< 16 digits.
  [[nodiscard]] std::string json() const;
  /// "the seeds (3 there, 5 now)" for the first part that differs from what json() once gave; empty: none does.
  [[nodiscard]] std::string difference_from(const std::string& json) const;
};

/// The scene counts as it is packed in double, the code as the texts of the scene's programs: what changes neither
/// changes no picture. reference: whatever tells references apart.
[[nodiscard]] StudyIdentity identity_of(const Device& device, const Scene& scene, int seeds,
                                        const std::string& reference);

}  // namespace strahl
