// SPDX-License-Identifier: MIT
// Every chooser. Only includes: a program holds the one that its scene calls for.
#include "choosers/uniform_lanes.h"
#include "choosers/power_lanes.h"
#include "choosers/importance_lanes.h"  // of each, tree
#include "choosers/each_lanes.h"
#include "choosers/tree_lanes.h"
