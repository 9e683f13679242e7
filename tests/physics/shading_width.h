// SPDX-License-Identifier: MIT
// From the sampler to the integrator, for the width LANES, as kernels/render.cl includes it. No guard: once a width.
#undef SCENE_LANES
// A number, since LANES has another value for a while (shapes/exact/exact_scalar.h).
#if LANES == 16
#define SCENE_LANES 16
#elif LANES == 8
#define SCENE_LANES 8
#else
#define SCENE_LANES 1
#endif
#include "lanes/lane_ops.h"
#if TIER_FAST
// The built-ins of OpenCL C that this tier alone has.
inline realw fmin(realw a, realw b) { return sel_w(lt_w(b, a), b, a); }
inline realw fmax(realw a, realw b) { return sel_w(lt_w(a, b), b, a); }
#endif
// Lanes come first: the other headers use their types and operations. Each header needs those above it.
#include "accel/traverse.h"
// As above.
#include "math/vec3_lanes.h"
// As above.
#include "math/sampling_lanes.h"
// As above.
#include "samplers/sampler_lanes.h"
// As above.
#include "rays/departing_lanes.h"
#if LANES != 1
#if TIER_ROBUST
// As above.
#include "shapes/exact/settle_lanes.h"
#endif
// As above.
#include "accel/packet.h"
#endif
// As above.
#include "hits/surfaces_lanes.h"
// As above.
#include "camera/camera_lanes.h"
// As above.
#include "camera/sample_place_lanes.h"
// As above.
#include "integrators/paths_lanes.h"
// As above.
#include "hits/find_lanes.h"
// As above.
#include "integrators/integrator_lanes.h"
