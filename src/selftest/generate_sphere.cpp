// SPDX-License-Identifier: MIT
// Spheres that a ray sees, stands above, stands in, leaves, or meets in crowds.
#include <algorithm>
#include <cmath>

#include "selftest/generators.h"

namespace strahl::selftest {
namespace {

Question one_sphere(const Vec3& center, double radius) {
  Question q = question_about("sphere");
  put(q, center);
  put(q, radius);
  return q;
}

/// From `distance` away, half of the rays at the disc that the sphere shows, half at its silhouette:
/// |1 - L / radius| = 2^-23 ... 2^-10.
Question seen(Draft& draft) {
  const double radius = to_float(draft.size("radius", 1)), distance = draft.size("distance", 10);
  const Vec3 to_center = draft.direction(), side = draft.perpendicular(to_center), center = draft.place();
  const double silhouette = radius * (1 + draft.random.sign() * std::ldexp(1.0, -draft.random.integer(10, 23)));
  const double wanted = draft.index % 2 == 0 ? radius * draft.random.uniform() : silhouette;
  const double sine = std::min(wanted / distance, 0.999999);
  Question q = one_sphere(center, radius);
  aim(q, center - distance * to_center, draft.scaled(std::sqrt(1 - sine * sine) * to_center + sine * side));
  return q;
}

/// An eye `height` above a planet, elevations from -1.5 to -0.001 rad and beside the horizon.
Question above(Draft& draft) {
  const double radius = to_float(draft.size("radius", 1)), height = draft.size("height", 1);
  const double slope = -std::exp(draft.random.uniform(std::log(0.001), std::log(1.5)));
  const double turn = draft.random.uniform(0, 6.283185307);
  Question q = one_sphere({0, -radius, 0}, radius);
  aim(q, {0, height, 0},
      draft.scaled({std::cos(slope) * std::cos(turn), std::sin(slope), std::cos(slope) * std::sin(turn)}));
  return q;
}

Question within(Draft& draft) {
  const double radius = to_float(draft.size("radius", 1));
  const Vec3 center = draft.place(), from = draft.random.uniform(0, 0.999) * radius * draft.direction();
  Question q = one_sphere(center, radius);
  aim(q, center + from, draft.scaled(draft.direction()));
  return q;
}

/// From the surface to rounding, declared as left: grazing to `tilt`, half of them inwards.
Question departed(Draft& draft) {
  const double radius = to_float(draft.size("radius", 1)), least = std::log(draft.size("tilt", 0x1p-20));
  const Vec3 center = draft.place(), normal = draft.direction(), along = draft.perpendicular(normal);
  const double tilt = draft.random.sign() * std::exp(draft.random.uniform(least, 0));
  Question q = one_sphere(center, radius);
  aim(q, center + radius * normal, draft.scaled(normalized(along + tilt * normal)));
  q.left = 0;
  return q;
}

/// Shells around one centre, `gap` apart, in any order.
Question shells(Draft& draft) {
  const double gap = draft.size("gap", 0x1p-14), distance = draft.size("distance", 4);
  const int count = draft.whole("shells", 2), turn = draft.random.integer(0, count - 1);
  const Vec3 center = draft.place(), to_center = draft.direction(), side = draft.perpendicular(to_center);
  Question q = question_about("sphere");
  for (int i = 0; i < count; ++i) {
    put(q, center);
    put(q, 1 + gap * ((i + turn) % count));
  }
  const double sine = draft.random.uniform(0, 0.999) / distance;
  aim(q, center - distance * to_center, std::sqrt(1 - sine * sine) * to_center + sine * side);
  return q;
}

/// Spheres of many sizes in a row, each touched by one line 2^-16 of its radius within its silhouette.
Question tangents(Draft& draft) {
  const int count = draft.whole("spheres", 1000), nearest = draft.random.integer(0, count - 1);
  Question q = question_about("sphere");
  for (int i = 0; i < count; ++i) {
    const double radius = to_float(std::exp2(draft.random.uniform(-3, 3)));
    const double turn = draft.random.uniform(0, 6.283185307), away = radius * (1 - 0x1p-16);
    put(q, Vec3{100.0 + 8 * ((i + count - nearest) % count), away * std::cos(turn), away * std::sin(turn)});
    put(q, radius);
  }
  aim(q, {0, 0, 0}, draft.scaled({1, 0, 0}));
  return q;
}

}  // namespace

const std::vector<Generator> sphere_generators = {{"sphere_seen", seen},     {"sphere_above", above},
                                                  {"sphere_within", within}, {"sphere_departed", departed},
                                                  {"sphere_shells", shells}, {"sphere_tangents", tangents}};

}  // namespace strahl::selftest
