// SPDX-License-Identifier: MIT
// Disks and cylinders.
#include <cmath>

#include "selftest/generators.h"

namespace strahl::selftest {
namespace {

/// From `distance` radii away, |n.d| from `tilt` to 1; half of the rays beside the rim, 2^-18 ... 2^-8 of the radius.
Question disk(Draft& draft) {
  const double size = draft.size("size", 1);
  const Vec3 center = draft.place(), normal = draft.direction();
  Question q = question_about("disk");
  put(q, center);
  put(q, draft.size("normal", 1) * normal);
  put(q, size * size);
  const double rim = 1 + draft.random.sign() * std::ldexp(1.0, -draft.random.integer(8, 18));
  const double away = size * (draft.index % 2 == 0 ? std::sqrt(draft.random.uniform()) : rim);
  const double tilt = std::exp(draft.random.uniform(std::log(draft.size("tilt", 0x1p-4)), 0));
  const Vec3 d = normalized(draft.perpendicular(normal) + draft.random.sign() * tilt * normal);
  aim(q, center + away * draft.perpendicular(normal) - draft.size("distance", 10) * size * d, draft.scaled(d));
  return q;
}

struct Mantle {
  Question q;
  Vec3 p0, axis;
  double radius, extent;
};

/// `extent` radii long.
Mantle mantle(Draft& draft) {
  Mantle m{question_about("cylinder"), draft.place(), to_float(draft.direction()), to_float(draft.size("size", 1)), 0};
  m.extent = to_float(m.radius * draft.size("extent", 4));
  put(m.q, m.p0);
  put(m.q, m.axis);
  put(m.q, m.extent);
  put(m.q, m.radius);
  return m;
}

/// From `distance` radii away: at the mantle, within 2^-16 ... 2^-8 of its silhouette, or of a rim.
Question cylinder(Draft& draft) {
  Mantle m = mantle(draft);
  const Vec3 axis = normalized(m.axis), out = draft.perpendicular(axis), side = cross(axis, out);
  const double near = 1 + draft.random.sign() * std::ldexp(1.0, -draft.random.integer(8, 16));
  const int place = draft.index % 3;
  const double aside = place == 0 ? draft.random.uniform(-1, 1) : place == 1 ? near : draft.random.uniform(-0.9, 0.9);
  const double along = place == 2 ? 0.5 + draft.random.sign() * 0.5 * near : draft.random.uniform(0.01, 0.99);
  const double tilt = draft.random.uniform(-1, 1) * draft.size("tilt", 1);
  const double drop = place == 2 ? std::sqrt(1 - aside * aside) : 0;
  const Vec3 d = normalized(tilt * axis - out);
  const Vec3 target = m.p0 + along * m.extent * axis + m.radius * (aside * side + drop * out);
  aim(m.q, target - draft.size("distance", 10) * m.radius * d, draft.scaled(d));
  return m.q;
}

/// From the mantle to rounding, declared as left.
Question departed(Draft& draft) {
  Mantle m = mantle(draft);
  const Vec3 axis = normalized(m.axis), out = draft.perpendicular(axis), side = cross(axis, out);
  const double least = std::log(draft.size("tilt", 0x1p-16));
  const double tilt = draft.random.sign() * std::exp(draft.random.uniform(least, 0));
  const Vec3 d = normalized(side + 0.5 * draft.random.uniform(-1, 1) * axis + tilt * out);
  aim(m.q, m.p0 + draft.random.uniform(0.1, 0.9) * m.extent * axis + m.radius * out, draft.scaled(d));
  m.q.left = 0;
  return m.q;
}

}  // namespace

const std::vector<Generator> disk_generators = {{"disk_seen", disk}};
const std::vector<Generator> cylinder_generators = {{"cylinder_seen", cylinder}, {"cylinder_departed", departed}};

}  // namespace strahl::selftest
