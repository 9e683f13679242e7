// SPDX-License-Identifier: MIT
// What the kernels that follow paths have in common, in PATH_LANES lanes from here on. Included once by each, behind
// its film, which has no width.
#include "kernels/whole_loops.h"
#if PATH_LANES != LANES
#undef LANES
#define LANES PATH_LANES
#endif
#include "math/vec3_lanes.h"
#include "math/sampling_lanes.h"
#include "samplers/sampler_lanes.h"
#include "rays/departing_lanes.h"
#if LANES != 1
#if TIER_ROBUST
#include "shapes/exact/settle_lanes.h"
#endif
#include "accel/packet.h"
#endif
#include "hits/surfaces_lanes.h"
#include "camera/camera_lanes.h"
#include "camera/sample_place_lanes.h"
#include "integrators/paths_lanes.h"
#include "camera/span_lanes.h"
#include "hits/find_lanes.h"
#include "integrators/integrator_lanes.h"
