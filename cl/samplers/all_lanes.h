// SPDX-License-Identifier: MIT
// Every sampler. Only includes: a program holds the one that is asked for.
#include "samplers/independent_lanes.h"
#include "samplers/sobol_lanes.h"
