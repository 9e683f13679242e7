// SPDX-License-Identifier: MIT
#define ROUTE double_words
#define ALL_WIDTHS 1
#define TIER robust_double_words
#define WIDE_IS_DOUBLE 0
#include "robust/kernels_body.h"
