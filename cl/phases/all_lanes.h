// SPDX-License-Identifier: MIT
// Every phase function. Only includes: a program holds those that its media have.
#include "phases/isotropic_lanes.h"
#include "phases/hg_lanes.h"
#include "phases/rayleigh_lanes.h"
