// SPDX-License-Identifier: MIT
// How fast a device reads memory: every work-item sums `turns` loads, as wide as the traversal's, so that all of them
// must arrive. A group reads one range; where work-items run in lanes, neighbouring work-items read neighbouring
// values.
#include "lanes/lane_ops.h"

KERNEL LANE_HINT void bandwidth(GLOBAL const real* in, GLOBAL real* out, int turns) {
  int item = (int)get_local_id(0), items = (int)get_local_size(0);
  int start = LANES == 1 ? item : item * turns * LANES, step = LANES == 1 ? items : LANES;
  GLOBAL const real* range = in + (ulong)get_group_id(0) * (ulong)(items * turns * LANES);
  realw sum = splat_w(R(0.0));
  for (int i = 0; i < turns; ++i) sum = sum + load_w(range + start + i * step);
  real values[LANES];
  store_w(sum, values);
  real total = values[0];
  for (int lane = 1; lane < LANES; ++lane) total += values[lane];
  out[get_global_id(0)] = total;
}
