// SPDX-License-Identifier: MIT
// The dialect in the robust tier by one route of kernels.h: its namespace is ROUTE, that of the dialect TIER.
// ALL_WIDTHS: 1, 8 and 16 lanes, and tracing; else one lane. No guard: once a unit.
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <vector>

#include "robust/kernels.h"

#define HAS_PIXEL_FILTER 1
#define HAS_THIN_LENS 1
#define HAS_EMISSION 1
#define HAS_TWOSIDED 1
#define HAS_TANGENT 1
#define HAS_RELIEF 1
#define HAS_SMOOTH_NORMALS 1
#define HAS_MESH_UVS 1
#define HAS_TEXTURE_LOD 1
#define HAS_INSTANCES 1
#define HAS_TREE 1
#define HAS_AOV 1
#define HAS_COUNT_RAYS 0

#define REAL_BITS 32
#define TIER_ROBUST 1
namespace TIER {
#define LANES 1
#include "lanes/lane_ops.h"
// Lanes come first: they define what the bodies are written in.
#include "hits/trace_one.h"
#undef LANES
#if ALL_WIDTHS
#define LANES 8
#include "lanes/lane_ops.h"
// As above.
#include "hits/trace_one.h"
#undef LANES
#define LANES 16
#include "lanes/lane_ops.h"
// As above.
#include "hits/trace_one.h"
#undef LANES
// They need the bodies.
#include "support/host_rays.h"
#endif
}  // namespace TIER

namespace strahl::test::ROUTE {

float robust_t(std::string_view kind, std::span<const float> planes, std::span<const float> ray, bool has_left) {
  using namespace TIER;
  const std::int32_t id = 0;
  const TIER::Ray prepared = ray_make(load3(ray.data() + RAY_O), load3(ray.data() + RAY_D), ray[RAY_T_MIN],
                                      ray[RAY_T_MAX], has_left ? id : -1);
  Nearest best = nearest_none(prepared.t_max);
#define SHAPE(name, planes_of_kind) \
  if (kind == #name) name##_block_w_1(&prepared, planes.data(), &id, 0, &best);
#include "shapes/shapes.def"
#undef SHAPE
  nearest_settle(&prepared, &best, 1);
  return best.kind < 0 ? std::numeric_limits<float>::infinity()
                       : ray_given_t(&prepared, best.t, ray[RAY_T_MIN], ray[RAY_T_MAX]);
}

bool robust_is_told(std::string_view kind, std::span<const float> planes, std::span<const float> ray) {
  using namespace TIER;
  const TIER::Ray prepared =
      ray_make(load3(ray.data() + RAY_O), load3(ray.data() + RAY_D), ray[RAY_T_MIN], ray[RAY_T_MAX], -1);
  ExactRays_w_1 one;
  exact_ray(&prepared, &one);
  if (kind == "triangle") {
    float least, most;
    polygon_range_w_1(&one, corner_of(planes.data(), 0, 1), corner_of(planes.data(), 1, 1),
                      corner_of(planes.data(), 2, 1), &least, &most);
    return least == most;
  }
  if (kind != "sphere") throw std::logic_error("no kind whose doubts are counted has this name");
  SphereRoots_w_1 roots;
  float t;
  return sphere_undecided_w_1(&one, center_of(planes.data(), 1), planes[3], ~none_w_1(), &roots, &t) == 0;
}

#if ALL_WIDTHS
std::array<float, 4> robust_ball(std::string_view kind, std::span<const float> planes) {
  using namespace TIER;
  TIER::Ball ball{{}, -1};
#define SHAPE(name, planes_of_kind) \
  if (kind == #name) ball = name##_ball_w_1(planes.data());
#include "shapes/shapes.def"
#undef SHAPE
  if (!(ball.radius >= 0)) throw std::logic_error("no ball of a kind of this name");
  return {ball.centre.x, ball.centre.y, ball.centre.z, ball.radius};
}

void robust_intersect(int lanes, const float* geometry, const float* shading, const std::int32_t* index,
                      const float* rays, const std::int32_t* left, std::size_t count, float* hits, std::int32_t* ids) {
  const TIER::Scene view{geometry, shading, index, nullptr};
  const auto trace = [&](auto find, auto describe) {
    TIER::host_rays(lanes, view, rays, left, count, false, find, describe, hits, ids);
  };
  if (lanes == 16)
    trace(TIER::find_rays_w_16, TIER::describe_one_w_16);
  else if (lanes == 8)
    trace(TIER::find_rays_w_8, TIER::describe_one_w_8);
  else
    trace(TIER::find_rays_w_1, TIER::describe_one_w_1);
}
#endif

}  // namespace strahl::test::ROUTE
