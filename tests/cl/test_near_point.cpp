// SPDX-License-Identifier: MIT
// The point on a polygon that is large beside the way to it (cl/shapes/polygon/near_point.h), in float: never farther
// off its plane than it says, and along the axes as near as the way's own rounding.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <random>

#include "cl/host_features.h"

#define REAL_BITS 32
namespace f32 {
#include "math/vec3.h"
// Vectors come first.
#include "shapes/polygon/near_point.h"
}  // namespace f32

namespace {

using f32::real3;
constexpr double u = 0x1p-24;

/// Corners of floats are exact in long double, and so are their differences here.
struct Wide {
  long double x, y, z;
};
Wide wide(const real3& a) { return {a.x, a.y, a.z}; }
Wide operator-(const Wide& a, const Wide& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
long double dot(const Wide& a, const Wide& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Wide cross(const Wide& a, const Wide& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
real3 turned(const real3& v, unsigned times) { return times == 0 ? v : turned(f32::vec3(v.y, v.z, v.x), times - 1); }

TEST_CASE("points of large polygons are off their planes by less than they say") {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> symmetric(-1, 1), decade(0, 7);
  const auto vector = [&](float size) {
    return f32::vec3(size * symmetric(random), size * symmetric(random), size * symmetric(random));
  };
  int along_axes = 0, slanted = 0;
  double nearest_to_bound = 0;
  for (unsigned i = 0; i < 200000; ++i) {
    const bool is_along = i % 2 == 0;
    const float size = std::pow(10.0F, decade(random));
    real3 a, e, f;
    if (is_along) {
      a = turned(f32::vec3(size * symmetric(random), size * symmetric(random), 3 * symmetric(random)), i % 3);
      e = turned(f32::vec3(size, 0, 0), i % 3);
      f = turned(f32::vec3(0, -size * (2 + symmetric(random)), 0), i % 3);
    } else {
      a = vector(size), e = vector(size), f = vector(size);
    }
    const real3 b = f32::add3(a, e), c = f32::add3(a, f);
    e = f32::sub3(b, a), f = f32::sub3(c, a);
    const Wide n = cross(wide(b) - wide(a), wide(c) - wide(a));
    const long double length = std::sqrt(dot(n, n));
    f32::Ray ray{};
    ray.o = vector(10), ray.d = vector(2);
    const long double t = dot(n, wide(a) - wide(ray.o)) / dot(n, wide(ray.d));
    if (!(t > 0 && t < 1e6L && length > 0)) continue;
    f32::Surface s = f32::surface_none();
    s.normal = f32::normalize3(f32::cross3(e, f));
    s.facing = f32::dot3(s.normal, ray.d);
    s.position = f32::ray_at(&ray, static_cast<float>(t));
    const real3 before = s.position;
    f32::take_near_point(&ray, a, e, f, &s);
    if (!(s.off > 0)) {
      CHECK((s.position.x == before.x && s.position.y == before.y && s.position.z == before.z));
      continue;
    }
    const double off = static_cast<double>(std::fabs(dot(n, wide(s.position) - wide(a))) / length);
    REQUIRE(off <= s.off);
    nearest_to_bound = std::max(nearest_to_bound, off / s.off);
    ++(is_along ? along_axes : slanted);
    if (!is_along) continue;
    const double way = static_cast<double>(t) * f32::max3(f32::abs3(ray.d)) + f32::max3(f32::abs3(ray.o));
    CHECK(s.off < 64 * u * way);
  }
  CAPTURE(along_axes, slanted, nearest_to_bound);
  CHECK(along_axes > 20000);
  CHECK(nearest_to_bound > 0.05);
}

}  // namespace
