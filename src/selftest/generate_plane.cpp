// SPDX-License-Identifier: MIT
// Planes far from the origin, seen from close by, grazingly, in pairs.
#include <cmath>

#include "selftest/generators.h"

namespace strahl::selftest {
namespace {

/// |n.d| from `tilt` to 1, evenly in its logarithm, either sign.
Vec3 towards(Draft& draft, const Vec3& normal) {
  const double tilt = std::exp(draft.random.uniform(std::log(draft.size("tilt", 0x1p-10)), 0));
  return normalized(draft.perpendicular(normal) + draft.random.sign() * tilt * normal);
}

void put_plane(Question& q, const Vec3& point, const Vec3& normal) {
  put(q, point);
  put(q, normal);
}

/// The eye `height` away from a plane through a point `offset` away, `aside` from that point; the normal as long as
/// `normal` says.
Question seen(Draft& draft) {
  const Vec3 normal = draft.direction(), point = draft.place();
  const double height = draft.size("height", 1), aside = draft.size("aside", 10);
  Question q = question_about("plane");
  put_plane(q, point, draft.size("normal", 1) * normal);
  aim(q, point + draft.random.uniform(0, aside) * draft.perpendicular(normal) + height * normal,
      draft.scaled(towards(draft, normal)));
  return q;
}

/// Two planes `gap` apart, `distance` away, either one first.
Question pair(Draft& draft) {
  const Vec3 normal = draft.direction(), point = draft.place();
  const double gap = draft.size("gap", 0x1p-16), distance = draft.size("distance", 1);
  const double sign = draft.random.sign();
  Question q = question_about("plane");
  put_plane(q, point, normal);
  put_plane(q, point + sign * gap * normal, normal);
  aim(q, point - distance * normal, normalized(normal + 0.5 * draft.random.uniform() * draft.perpendicular(normal)));
  return q;
}

/// From a point of the plane to rounding, declared as left.
Question departed(Draft& draft) {
  const Vec3 normal = draft.direction(), point = draft.place();
  Question q = question_about("plane");
  put_plane(q, point, normal);
  aim(q, point + draft.random.uniform(0, 10) * draft.perpendicular(normal), towards(draft, normal));
  q.left = 0;
  return q;
}

}  // namespace

const std::vector<Generator> plane_generators = {
    {"plane_seen", seen}, {"plane_pair", pair}, {"plane_departed", departed}};

}  // namespace strahl::selftest
