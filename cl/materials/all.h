// SPDX-License-Identifier: MIT
// Every material. Only includes: a program holds those that its scene uses.
#include "materials/diffuse.h"
#include "materials/conductor.h"
