// SPDX-License-Identifier: MIT
// What the bits of a picture depend on: as long as it is the same, an earlier run's film can be gone on from, and parts
// add up (docs/decisions/0029-checkpoints.md).
#pragma once

#include <string>
#include <vector>

#include "opencl/device.h"
#include "render/renderer.h"

namespace strahl {

/// What a message calls it; what must be the same; what it is besides (a file's name), which may differ.
struct IdentityPart {
  std::string name, value, note;
};

struct PictureIdentity {
  std::vector<IdentityPart> parts;

  /// "the seed is 1 there and 2 here" for the first part that differs; empty where none does. there: the other's place.
  [[nodiscard]] std::string difference_from(const PictureIdentity& other) const;
};

/// defines: -D, which the scene no longer shows. Reads the scene's files once more; throws InputError where one of them
/// is a pipe, whose content is gone.
[[nodiscard]] PictureIdentity identity_of(const Device& device, const Renderer& renderer,
                                          const RenderSettings& settings, const std::vector<std::string>& defines,
                                          const RenderGoal& goal);

}  // namespace strahl
