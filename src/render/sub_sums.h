// SPDX-License-Identifier: MIT
// Which of a pixel's sub-sums a sample goes to, for the host: cl/film/sub_sums.h, used by both sides.
#pragma once

namespace strahl {

#define FN [[nodiscard]] inline
#include "../../cl/film/sub_sums.h"
#undef FN

}  // namespace strahl
