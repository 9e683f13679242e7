// SPDX-License-Identifier: MIT
// Slabs (Kay, Kajiya, "Ray Tracing Complex Scenes", SIGGRAPH 1986) in exact arithmetic.
#include <algorithm>

#include "oracle/number.h"

namespace strahl::oracle {
namespace {

template <class N>
AabbAnswer solve(const Ray& ray, const Aabb& box) {
  const std::array<double, 3> o{ray.origin.x, ray.origin.y, ray.origin.z};
  const std::array<double, 3> d{ray.direction.x, ray.direction.y, ray.direction.z};
  const std::array<double, 3> low{box.min.x, box.min.y, box.min.z}, high{box.max.x, box.max.y, box.max.z};

  AabbAnswer answer;
  N entry(0), exit(0);
  bool is_first = true;
  for (int axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    if (low[i] > high[i]) return {};
    if (d[i] == 0) {
      if (o[i] < low[i] || o[i] > high[i]) return {};
      continue;
    }
    const N first = (N(d[i] > 0 ? low[i] : high[i]) - N(o[i])) / N(d[i]);
    const N last = (N(d[i] > 0 ? high[i] : low[i]) - N(o[i])) / N(d[i]);
    if (is_first || sign(N(first - entry)) > 0) entry = first, answer.entry_axis = axis;
    if (is_first || sign(N(last - exit)) < 0) exit = last, answer.exit_axis = axis;
    is_first = false;
  }

  answer.entry = to_exact(entry);
  answer.exit = to_exact(exit);
  const double scale = std::max(std::fabs(answer.entry.value), std::fabs(answer.exit.value));
  answer.margin = scale == 0 ? 0 : to_double(N(exit - entry)) / scale;
  answer.line_meets = sign(N(exit - entry)) >= 0;
  if (!answer.line_meets) return answer;
  answer.range_margin = std::fmin(range_gap(ray, answer.entry), range_gap(ray, answer.exit));
  const bool enters_late = std::isfinite(ray.t_max) && sign(N(entry - N(ray.t_max))) > 0;
  const bool exits_early = std::isfinite(ray.t_min) && sign(N(exit - N(ray.t_min))) < 0;
  answer.overlaps = ray.t_min <= ray.t_max && !enters_late && !exits_early;
  const bool is_entry = in_range(ray, entry);
  answer.hit = is_entry || (answer.overlaps && in_range(ray, exit));
  answer.t = is_entry ? answer.entry : answer.exit;
  return answer;
}

}  // namespace

AabbAnswer aabb(const Ray& ray, const Aabb& box, Arithmetic arithmetic) {
  if (is_zero(ray.direction)) return {};
  return decide(arithmetic, [&]<class N>() { return solve<N>(ray, box); });
}

}  // namespace strahl::oracle
