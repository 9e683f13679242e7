// SPDX-License-Identifier: MIT
// Single triangles and parallelograms of any size, place and shape, and closed rooms of parallelograms.
#include <cmath>

#include "selftest/generators.h"

namespace strahl::selftest {
namespace {

struct Sides {
  Vec3 u, v;
};

/// Two sides of `size`, one of them `thickness` as wide as the other is long.
Sides sides(Draft& draft) {
  const double size = draft.size("size", 1), thickness = draft.size("thickness", 1);
  const Vec3 u = draft.direction();
  return {size * u, size * thickness * normalized(draft.perpendicular(u) + 0.5 * u)};
}

/// From `distance` away at the target, |n.d| from `tilt` to 1.
void aim_at(Draft& draft, Question& q, const Vec3& target, const Vec3& normal) {
  const double tilt = std::exp(draft.random.uniform(std::log(draft.size("tilt", 0x1p-4)), 0));
  const Vec3 d = normalized(draft.perpendicular(normal) + draft.random.sign() * tilt * normal);
  aim(q, target - draft.size("distance", 10) * draft.size("size", 1) * d, draft.scaled(d));
}

Question triangle(Draft& draft) {
  const Vec3 corner = draft.place();
  const auto [u, v] = sides(draft);
  Question q = question_about("triangle");
  for (const Vec3& p : {corner, corner + u, corner + v}) put(q, p);
  const double s = draft.random.uniform(), t = draft.random.uniform() * (1 - s);
  aim_at(draft, q, corner + s * u + t * v, normalized(cross(u, v)));
  return q;
}

/// Corners on a lattice, so that they close.
Question parallelogram(Draft& draft) {
  const double cell = std::exp2(std::floor(std::log2(draft.size("size", 1) + draft.size("offset", 0))) - 20);
  const auto on_lattice = [&](const Vec3& p) {
    return Vec3{cell * std::round(p.x / cell), cell * std::round(p.y / cell), cell * std::round(p.z / cell)};
  };
  const Vec3 corner = on_lattice(draft.place());
  const auto given = sides(draft);
  const Vec3 u = on_lattice(given.u), v = on_lattice(given.v);
  Question q = question_about("parallelogram");
  for (const Vec3& p : {corner, corner + u, corner + u + v, corner + v}) put(q, p);
  const double s = draft.random.uniform(-0.1, 1.1), t = draft.random.uniform(-0.1, 1.1);
  aim_at(draft, q, corner + s * u + t * v, normalized(cross(u, v)));
  return q;
}

/// Six parallelograms, seen from inside at what they share: a box with tilted walls.
/// On a lattice, so that the corners close: `size` is a power of two.
Question room(Draft& draft) {
  const double size = draft.size("size", 1);
  const auto lattice = [&](const Vec3& p) {
    return Vec3{std::round(8 * p.x) / 8, std::round(8 * p.y) / 8, std::round(8 * p.z) / 8};
  };
  const Vec3 center = size * lattice(1 / size * draft.place());
  Vec3 edge[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (Vec3& e : edge) e = lattice(e + 0.4 * draft.direction());
  const auto corner = [&](int i, int j, int k) {
    return to_float(center + size * ((2.0 * i - 1) * edge[0] + (2.0 * j - 1) * edge[1] + (2.0 * k - 1) * edge[2]));
  };
  Question q = question_about("parallelogram");
  for (int side = 0; side < 2; ++side) {
    for (const Vec3& p : {corner(side, 0, 0), corner(side, 1, 0), corner(side, 1, 1), corner(side, 0, 1)}) put(q, p);
    for (const Vec3& p : {corner(0, side, 0), corner(0, side, 1), corner(1, side, 1), corner(1, side, 0)}) put(q, p);
    for (const Vec3& p : {corner(0, 0, side), corner(1, 0, side), corner(1, 1, side), corner(0, 1, side)}) put(q, p);
  }
  const Vec3 origin = to_float(center + 0.3 * size * draft.direction());
  const auto bit = [&] { return draft.random.integer(0, 1); };
  const Vec3 a = corner(bit(), bit(), bit()), b = corner(bit(), bit(), bit());
  const Vec3 target = a + 0.5 * draft.random.integer(0, 2) * (b - a);
  aim(q, origin, draft.scaled(1 / size * (target - origin)));
  return q;
}

}  // namespace

const std::vector<Generator> triangle_generators = {{"triangle_seen", triangle}};
const std::vector<Generator> parallelogram_generators = {{"rectangle_seen", parallelogram},
                                                         {"rectangle_room", room, Surface::convex}};

}  // namespace strahl::selftest
