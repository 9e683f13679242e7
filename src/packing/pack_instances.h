// SPDX-License-Identifier: MIT
// Groups that instances place, and what the kernels know of an instance (docs/decisions/0009-instances.md).
#pragma once

#include <array>
#include <vector>

#include "kinds/upload_frame.h"
#include "packing/cl_layout.h"
#include "packing/primitive_bounds.h"
#include "scene/model/scene.h"

namespace strahl {

/// The frame that a group's shapes are uploaded in: around its middle and of ordinary size; its own where the scene is
/// uploaded in the world's frame.
[[nodiscard]] UploadFrame group_frame(const Group& group, const UploadFrame& scene);

/// From the group's frame into the scene's.
[[nodiscard]] Transform frame_from_group(const Instance& instance, const UploadFrame& group, const UploadFrame& scene);

template <typename Real>
using InstanceReals = std::array<Real, layout::INSTANCE_REALS>;

/// box: around what the group holds as it is uploaded. outline: boxes within it that hold the same, so that the
/// instance's own box is no larger than they take; empty: `box` stands for them. SceneError at `where` if Real does not
/// hold the map. Instantiated for float and double.
template <typename Real>
[[nodiscard]] InstanceReals<Real> instance_reals(const Transform& frame_from_group, const Bounds<Real>& box,
                                                 const std::vector<Bounds<Real>>& outline,
                                                 const SourceLocation& where = {});

}  // namespace strahl
