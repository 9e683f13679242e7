// SPDX-License-Identifier: MIT
#define REAL_BITS 32
#define LANES 16
#include "cl/pixel_samples_body.h"
