// SPDX-License-Identifier: MIT
// Every light. Only includes: a program holds those that its scene uses.
#include "lights/point.h"
#include "lights/directional.h"
#include "lights/constant.h"
#include "lights/area.h"
