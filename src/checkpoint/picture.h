// SPDX-License-Identifier: MIT
// The picture that a checkpoint's film shows so far.
#pragma once

#include "checkpoint/checkpoint.h"
#include "render/renderer.h"

namespace strahl {

/// Mean and AOVs; not numeric_error, which a render alone can tell, since the scene is needed. Nothing else is filled
/// in.
[[nodiscard]] RenderResult picture_of(const Checkpoint& checkpoint);

}  // namespace strahl
