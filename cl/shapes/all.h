// SPDX-License-Identifier: MIT
// Every shape's scalar part. Only includes: a program holds those of the shapes that its scene uses.
#include "shapes/sphere/sphere.h"
#include "shapes/plane/plane.h"
#include "shapes/box/box.h"
#include "shapes/triangle/triangle.h"
#include "shapes/parallelogram/parallelogram.h"
#include "shapes/disk/disk.h"
#include "shapes/cylinder/cylinder.h"
