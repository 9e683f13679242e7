// SPDX-License-Identifier: MIT
#define REAL_BITS 64
#include "cl/sampling_body.h"
