// SPDX-License-Identifier: MIT
// What the units of nearest.h share. No guard: included once, in the namespace of a tier, after its defines.
#define LANES 1
#include "lanes/lane_ops.h"
// Lanes come first: they define what the bodies are written in.
#define HAS_INSTANCES 0
#define HAS_TREE 1
#define HAS_COUNT_RAYS 0
#include "accel/traverse.h"
#undef LANES

inline strahl::test::Nearest nearest_of(std::string_view kind, std::span<const double> planes,
                                        std::span<const double> given, int left) {
  const std::vector<real> values(planes.begin(), planes.end()), r(given.begin(), given.end());
  const Ray ray = ray_make(load3(r.data() + RAY_O), load3(r.data() + RAY_D), r[RAY_T_MIN], r[RAY_T_MAX], left);
  Nearest best = nearest_none(ray.t_max);
#define SHAPE(name, reals)                                               \
  if (kind == #name)                                                     \
    for (std::size_t i = 0; (i + 1) * reals <= values.size(); ++i) {     \
      const int id = static_cast<int>(i);                                \
      name##_block_w_1(&ray, values.data() + i * reals, &id, id, &best); \
    }
#include "shapes/shapes.def"
#undef SHAPE
#if TIER_ROBUST
  nearest_settle(&ray, &best, 1);
#endif
  if (best.kind < 0) return {INFINITY, -1};
  return {ray_given_t(&ray, best.t, r[RAY_T_MIN], r[RAY_T_MAX]), best.id};
}
