// SPDX-License-Identifier: MIT
// Every integrator. Only includes: a program holds the one that is asked for.
#include "integrators/emission_lanes.h"
#include "integrators/depth_lanes.h"
#include "integrators/normals_lanes.h"
#include "integrators/direct_lanes.h"
#include "integrators/whitted_lanes.h"
#include "integrators/path_lanes.h"
#include "integrators/volpath_lanes.h"
#include "integrators/ao_lanes.h"
#include "integrators/adjoint_lanes.h"  // of ptracer, bdpt
#include "integrators/sensor_lanes.h"   // of ptracer, bdpt
#include "integrators/ptracer_lanes.h"
#include "integrators/bdpt_lanes.h"
