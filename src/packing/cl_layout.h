// SPDX-License-Identifier: MIT
// The kernels' own buffer layout, for the host: one definition, read by both sides.
#pragma once

namespace strahl::layout {
#include "../../cl/media/media_layout.h"
#include "../../cl/scene/layout.h"
}  // namespace strahl::layout
