// SPDX-License-Identifier: MIT
#define REAL_BITS 64
#include "physics/lights_body.h"
