// SPDX-License-Identifier: MIT
// Every integrator. Only includes: a program holds the one that is asked for.
#include "integrators/emission.h"
#include "integrators/depth.h"
#include "integrators/normals.h"
#include "integrators/direct.h"
#include "integrators/whitted.h"
#include "integrators/path.h"
#include "integrators/ao.h"
