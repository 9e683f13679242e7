// SPDX-License-Identifier: MIT
// Leaving a sphere or a cylinder in the robust tier: the point where it was left is not met again, the other root is,
// -2 (f.d) / (d.d) across the axis, to the last place however grazing the ray is.
#include <catch2/catch.hpp>

#include "oracle/number.h"
#include "robust/ask_host.h"

using namespace strahl;
using namespace strahl::selftest;
using namespace strahl::test;

namespace {

using Long = oracle::Vector<long double>;

Vec3 direction(oracle::Random& random) {
  return normalized(Vec3{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)});
}

/// From a point with the given normal: into the shape or out of it, now and then as good as tangent.
Vec3 departing(oracle::Random& random, const Vec3& normal) {
  const Vec3 any = direction(random), tangent = normalized(any - dot(any, normal) * normal);
  const double tilt = random.sign() * std::fabs(random.log_uniform(-6, 0));
  return to_float(tangent + tilt * normal);
}

double ulps_of(float t, long double exact) {
  const auto value = static_cast<double>(exact);
  return oracle::ulp_error_f32(t, {value, static_cast<double>(exact - value)});
}

}  // namespace

TEST_CASE("a sphere that was left is met at its other root only") {
  oracle::Random random(1);
  double worst = 0;
  int far_sides = 0;
  for (int i = 0; i < 100000; ++i) {
    const double radius = to_float(std::fabs(random.log_uniform(-3, 3)));
    const Vec3 center = to_float(100 * direction(random)), normal = direction(random);
    Question q;
    put(q.planes, center);
    q.planes.push_back(to_float(radius));
    q.ray.origin = to_float(center + radius * normal);
    q.ray.direction = departing(random, normal);
    const Long f = Long(q.ray.origin) - Long(center), d(q.ray.direction);
    const long double other = -2 * dot(f, d) / dot(d, d);
    q.kind = "sphere";
    q.left = 0;
    const float t = ask_host(q);
    if (std::isfinite(t) != (other > 0)) FAIL("case " << i << ": t " << t << ", other root " << other);
    if (other <= 0) continue;
    ++far_sides;
    worst = std::max(worst, ulps_of(t, other));
  }
  CHECK(far_sides > 40000);
  CHECK(worst <= 0.51);
}

TEST_CASE("a cylinder that was left is met at its other root only") {
  oracle::Random random(2);
  double worst = 0;
  int far_sides = 0;
  for (int i = 0; i < 100000; ++i) {
    const double radius = to_float(std::fabs(random.log_uniform(-2, 2)));
    const Vec3 p0 = to_float(100 * direction(random)), axis = to_float(direction(random));
    const Vec3 any = direction(random), normal = normalized(any - dot(any, axis) * axis);
    const double extent = to_float(1000 * radius);
    Question q;
    put(q.planes, p0);
    put(q.planes, axis);
    q.planes.push_back(to_float(extent));
    q.planes.push_back(to_float(radius));
    q.ray.origin = to_float(p0 + 0.5 * extent * axis + radius * normal);
    q.ray.direction = departing(random, normal);
    const Long v(axis), f = Long(q.ray.origin) - Long(p0), d(q.ray.direction), across = cross(d, v);
    const long double other = -2 * dot(cross(f, v), across) / dot(across, across);
    const long double place = dot(f + other * d, v) / dot(v, v);
    // Clear of the ends.
    if (!(std::fabs(place - extent / 2) < 0.4L * extent) && other > 0) continue;
    q.kind = "cylinder";
    q.left = 0;
    const float t = ask_host(q);
    if (std::isfinite(t) != (other > 0)) FAIL("case " << i << ": t " << t << ", other root " << other);
    if (other <= 0) continue;
    ++far_sides;
    // What is left of (f x v).(d x v) by cancellation is good to 16 u^2 of |f x v| |d x v|.
    const long double cancelled = 32 * u * u * std::sqrt(dot(cross(f, v), cross(f, v)) / dot(across, across));
    if (std::fabs(t - other) > cancelled) worst = std::max(worst, ulps_of(t, other));
  }
  CHECK(far_sides > 40000);
  CHECK(worst <= 1);
}
