// SPDX-License-Identifier: MIT
#define REAL_BITS 32
#include "physics/lights_body.h"
