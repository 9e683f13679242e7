// SPDX-License-Identifier: MIT
// Whether rays hit anything.
#define STOP_AT_FIRST 1
#include "kernels/find_lanes.h"
