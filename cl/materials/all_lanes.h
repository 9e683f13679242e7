// SPDX-License-Identifier: MIT
// Every material. Only includes: a program holds those that its scene uses.
#include "materials/diffuse_lanes.h"
#include "materials/conductor_lanes.h"
#include "materials/dielectric_lanes.h"
