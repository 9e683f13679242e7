// SPDX-License-Identifier: MIT
// Every area. Only includes: a program holds those that its scene's emitters are made of.
#include "areas/triangle.h"
#include "areas/parallelogram.h"
#include "areas/disk.h"
#include "areas/sphere.h"
#include "areas/cylinder.h"
