// SPDX-License-Identifier: MIT
// Spheres and cylinders worked by hand, and catalogue rows S04, S11, S12, S13, S14, S15, S16, S17, S18, S19, S20, S22.
#include <catch2/catch.hpp>
#include <cmath>

#include "oracle/oracle.h"

using namespace strahl::oracle;

namespace {

const Sphere unit{{0, 0, 0}, 1};
const Cylinder tube{{0, 0, 0}, {0, 0, 2}, 1};

double f32(float x) { return static_cast<double>(x); }

}  // namespace

TEST_CASE("sphere from outside, inside, behind and at its centre") {
  const QuadricAnswer outside = sphere({{-5, 0, 0}, {1, 0, 0}}, unit);
  CHECK(outside.hit);
  CHECK(outside.t.value == 4);
  CHECK(outside.t.rest == 0);
  CHECK(outside.root[1].value == 6);
  CHECK(outside.margin == 1);
  CHECK(outside.range_margin == 1);

  CHECK(sphere({{0.5, 0, 0}, {1, 0, 0}}, unit).t.value == 0.5);
  CHECK(sphere({{0, 0, 0}, {0, -1, 0}}, unit).t.value == 1);
  const QuadricAnswer behind = sphere({{5, 0, 0}, {1, 0, 0}}, unit);
  CHECK_FALSE(behind.hit);
  CHECK(behind.discriminant_sign == 1);
  CHECK(behind.root[0].value == -6);
}

TEST_CASE("sphere: t is in units of the direction's length") {
  for (const double length : {1e-20, 1e-3, 1e3, 1e18}) {
    const Exact t = sphere({{-5, 0, 0}, {length, 0, 0}}, unit).t;
    CHECK(ulp_error_f64(4 / length, t) <= 1);
  }
}

TEST_CASE("sphere: the range is closed at both ends") {
  CHECK(sphere({{-5, 0, 0}, {1, 0, 0}, 4, 4}, unit).hit);
  CHECK(sphere({{-5, 0, 0}, {1, 0, 0}, std::nextafter(4, 5), 10}, unit).t.value == 6);
  CHECK_FALSE(sphere({{-5, 0, 0}, {1, 0, 0}, 0, std::nextafter(4, 3)}, unit).hit);
  CHECK(sphere({{5, 0, 0}, {1, 0, 0}, -INFINITY, INFINITY}, unit).t.value == -6);
}

TEST_CASE("sphere: exactly tangent touches, one ulp beside does not (S12, S13)") {
  const QuadricAnswer tangent = sphere({{-5, 1, 0}, {1, 0, 0}}, unit);
  CHECK(tangent.hit);
  CHECK(tangent.discriminant_sign == 0);
  CHECK(tangent.t.value == 5);
  CHECK(tangent.margin == 0);
  const QuadricAnswer beside = sphere({{-5, std::nextafter(1.0, 2.0), 0}, {1, 0, 0}}, unit);
  CHECK_FALSE(beside.hit);
  CHECK(beside.margin == Approx(-0x1p-51));
  const QuadricAnswer within = sphere({{-5, std::nextafter(1.0, 0.0), 0}, {1, 0, 0}}, unit);
  CHECK(within.hit);
  CHECK(within.t.value == Approx(5 - 0x1p-26));
}

TEST_CASE("sphere: origin on the surface has the roots 0 and another (S15)") {
  CHECK(sphere({{1, 0, 0}, {1, 0, 0}}, unit).t.value == 0);
  const QuadricAnswer inwards = sphere({{1, 0, 0}, {-1, 0, 0}, std::nextafter(0, 1)}, unit);
  CHECK(inwards.t.value == 2);
  CHECK(sphere({{1, 0, 0}, {0, 1, 0}}, unit).t.value == 0);
}

TEST_CASE("sphere: zero direction and radius 0 miss (S19, S20); denormal ones do not (S22)") {
  CHECK_FALSE(sphere({{0, 0, 0}, {0, 0, 0}}, unit).hit);
  CHECK_FALSE(sphere({{-5, 0, 0}, {1, 0, 0}}, {{0, 0, 0}, 0}).hit);
  const QuadricAnswer tiny = sphere({{-3e-320, 0, 0}, {1, 0, 0}}, {{0, 0, 0}, 1e-320});
  CHECK(tiny.hit);
  CHECK(tiny.t.value == 3e-320 - 1e-320);
}

TEST_CASE("sphere: unit spheres far away stay visible (S04)") {
  for (const double distance : {100.0, 2000.0, 4100.0, 8000.0, 1e7}) {
    CHECK(sphere({{0, 0.5, 0}, {0, 0, -1}}, {{0, 0, -distance}, 1}).t.value == distance - std::sqrt(0.75));
    CHECK_FALSE(sphere({{0, 1.0001, 0}, {0, 0, -1}}, {{0, 0, -distance}, 1}).hit);
  }
}

TEST_CASE("sphere: Embree's overlapping spheres give the first at 10.2983 (S11)") {
  const Ray ray{{f32(14.8001127f), f32(-9.01768494f), f32(3.47012758f)},
                {f32(-.989340246f), f32(-.0190101117f), f32(-.144376263f)}};
  const QuadricAnswer first = sphere(ray, {{f32(9.66870880f), f32(-16.3965702f), f32(3.93995930f)}, 9});
  const QuadricAnswer second = sphere(ray, {{f32(10.0441875f), f32(-9.69345284f), f32(3.94893074f)}, 9});
  REQUIRE(first.hit);
  REQUIRE(second.hit);
  CHECK(first.t.value == Approx(10.2983).epsilon(1e-5));
  CHECK(first.t.value < second.t.value);
}

TEST_CASE("cylinder from outside, inside, past its ends") {
  const QuadricAnswer outside = cylinder({{-5, 0, 1}, {1, 0, 0}}, tube);
  CHECK(outside.t.value == 4);
  CHECK(outside.root[1].value == 6);
  CHECK(outside.margin == 0.5);
  CHECK(cylinder({{0, 0, 1}, {1, 0, 0}}, tube).t.value == 1);
  CHECK_FALSE(cylinder({{-5, 0, 3}, {1, 0, 0}}, tube).hit);
  CHECK_FALSE(cylinder({{-5, 0, -1e-9}, {1, 0, 0}}, tube).hit);
  // Through the open end: the near root is beyond it, the far one is on the mantle.
  const QuadricAnswer through_end = cylinder({{-2, 0, 4}, {1, 0, -1}}, tube);
  CHECK(through_end.on_shape == std::array{false, true});
  CHECK(through_end.t.value == 3);
}

TEST_CASE("cylinder: rims belong to it, exactly, also at irrational roots") {
  CHECK(cylinder({{-5, 0, 0}, {1, 0, 0}}, tube).hit);
  CHECK(cylinder({{-5, 0, 2}, {1, 0, 0}}, tube).hit);
  CHECK(cylinder({{-5, 0, 2}, {1, 0, 0}}, tube).margin == 0);
  CHECK_FALSE(cylinder({{-5, 0, std::nextafter(2, 3)}, {1, 0, 0}}, tube).hit);
  // At y = 1/2 the roots are -+ sqrt(3)/2; the ray stays in the rim's plane.
  CHECK(cylinder({{-5, 0.5, 2}, {1, 0, 0}}, tube).hit);
}

TEST_CASE("cylinder: tangent touches; along the axis and without axis or radius it misses") {
  CHECK(cylinder({{-5, 1, 1}, {1, 0, 0}}, tube).hit);
  CHECK(cylinder({{-5, 1, 1}, {1, 0, 0}}, tube).discriminant_sign == 0);
  CHECK_FALSE(cylinder({{-5, std::nextafter(1, 2), 1}, {1, 0, 0}}, tube).hit);
  CHECK_FALSE(cylinder({{0, 0, -5}, {0, 0, 1}}, tube).hit);
  CHECK_FALSE(cylinder({{1, 0, -5}, {0, 0, 1}}, tube).hit);
  CHECK_FALSE(cylinder({{-5, 0, 1}, {1, 0, 0}}, {{0, 0, 0}, {0, 0, 0}, 1}).hit);
  CHECK_FALSE(cylinder({{-5, 0, 1}, {1, 0, 0}}, {{0, 0, 0}, {0, 0, 2}, 0}).hit);
  CHECK_FALSE(cylinder({{-5, 0, 1}, {0, 0, 0}}, tube).hit);
}

TEST_CASE("cylinder with an oblique axis: across it, the sphere of the same radius gives the same roots") {
  const Cylinder oblique{{1, 2, 3}, {2, 4, 4}, 3};
  // From the axis' middle (2, 4, 5), at right angles to it, |d| = 3: the mantle is one length away on either side.
  const strahl::Vec3 d{2, 1, -2};
  CHECK(cylinder({{2, 4, 5}, d}, oblique).t.value == 1);
  CHECK(cylinder({{2 - 4 * d.x, 4 - 4 * d.y, 5 - 4 * d.z}, d}, oblique).t.value == 3);
}
