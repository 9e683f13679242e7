// SPDX-License-Identifier: MIT
#define REAL_BITS 64
#define LANES 8
#include "cl/pixel_samples_body.h"
