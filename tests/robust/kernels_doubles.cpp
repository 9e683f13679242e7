// SPDX-License-Identifier: MIT
#define ROUTE doubles
#define ALL_WIDTHS 0
#define TIER robust_doubles
#define WIDE_IS_DOUBLE 1
#include "robust/kernels_body.h"
