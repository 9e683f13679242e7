// SPDX-License-Identifier: MIT
// No rounding is certain, so that all is decided exactly.
#define ROUTE exact
#define ALL_WIDTHS 0
#define TIER robust_exact
#define DOUBLE_WORD_ROUNDOFF R(1.0)
#include "robust/kernels_body.h"
