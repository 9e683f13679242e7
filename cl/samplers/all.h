// SPDX-License-Identifier: MIT
// Every sampler. Only includes: a program holds the one that is asked for.
#include "samplers/independent.h"
#include "samplers/sobol.h"
