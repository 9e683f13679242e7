// SPDX-License-Identifier: MIT
// Every shape's scalar part. Only includes: a program holds those of the shapes that its scene uses.
#include "shapes/sphere.h"
#include "shapes/plane.h"
#include "shapes/box.h"
#include "shapes/triangle.h"
#include "shapes/parallelogram.h"
#include "shapes/disk.h"
#include "shapes/cylinder.h"
