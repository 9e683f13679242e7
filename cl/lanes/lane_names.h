// SPDX-License-Identifier: MIT
// Names that depend on the width. LANED(x) is x_1, x_8 or x_16, by the value of LANES at the place of use. So a body
// written once over realw, intw and maskw exists at every width. Code says x_w, which lane_table.h turns into x_w_1,
// x_w_8 or x_w_16. Bare names (any, select) would rewrite built-ins and standard headers for the rest of the unit.
#ifndef STRAHL_LANE_NAMES_H
#define STRAHL_LANE_NAMES_H

#define LANED_PASTE(name, lanes) name##_##lanes
#define LANED_EXPAND(name, lanes) LANED_PASTE(name, lanes)
#define LANED(name) LANED_EXPAND(name, LANES)

/// On kernels with wide bodies: tells runtimes that vectorise across work-items to leave them alone.
#define WIDE_BODIES_1
#define WIDE_BODIES_8 __attribute__((vec_type_hint(float8)))
#define WIDE_BODIES_16 __attribute__((vec_type_hint(float16)))
#define LANE_HINT_OF(lanes) LANED_EXPAND(WIDE_BODIES, lanes)
#define LANE_HINT LANE_HINT_OF(LANES)

/// As FN, for large functions of which a program with wide lanes holds one copy (docs/decisions/0017-once.md). With one
/// lane they are inlined.
#define WIDE_FN_1 FN
#define WIDE_FN_8 SELDOM_FN
#define WIDE_FN_16 SELDOM_FN
#define WIDE_FN LANED_EXPAND(WIDE_FN, LANES)

#define realw LANED(realw)
#define intw LANED(intw)
#define maskw LANED(maskw)
#define uintw LANED(uintw)
#define real3w LANED(real3w)

#include "lanes/lane_table.h"

#endif
