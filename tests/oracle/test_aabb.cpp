// SPDX-License-Identifier: MIT
// Boxes worked by hand: catalogue rows A01-A05, A06, A07, A08, A10, A11, A12.
#include <catch2/catch.hpp>
#include <cmath>

#include "oracle/oracle.h"

using namespace strahl::oracle;

namespace {

const Aabb cube{{-1, -1, -1}, {1, 1, 1}};

}  // namespace

TEST_CASE("box from outside: entry, exit and their axes") {
  const AabbAnswer a = aabb({{-5, 0.5, 0}, {2, 0, 0}}, cube);
  CHECK(a.hit);
  CHECK(a.t.value == 2);
  CHECK(a.exit.value == 3);
  CHECK(a.entry_axis == 0);
  CHECK(aabb({{0, 0, 7}, {0.125, 0, -1}}, cube).entry_axis == 2);
  CHECK(a.overlaps);
  CHECK_FALSE(aabb({{5, 0, 0}, {1, 0, 0}}, cube).hit);
  CHECK(aabb({{5, 0, 0}, {1, 0, 0}}, cube).line_meets);
  CHECK_FALSE(aabb({{5, 0, 0}, {1, 0, 0}}, cube).overlaps);
  CHECK_FALSE(aabb({{-5, 0, 0}, {1, 1, 0}}, cube).line_meets);
}

TEST_CASE("box: zero components of either sign inside, outside, on the face (A01, A02)") {
  for (const double zero : {0.0, -0.0}) {
    for (const double y : {-1.0, 0.0, 1.0}) CHECK(aabb({{-5, y, 0}, {1, zero, zero}}, cube).t.value == 4);
    for (const double y : {std::nextafter(-1, -2), std::nextafter(1, 2)})
      CHECK_FALSE(aabb({{-5, y, 0}, {1, zero, zero}}, cube).line_meets);
    CHECK(aabb({{1, 1, -5}, {zero, zero, 1}}, cube).hit);
    CHECK(aabb({{1, -5, 1}, {zero, 1, 1e-300}}, cube).line_meets == false);
  }
  CHECK_FALSE(aabb({{0, 0, 0}, {0, -0.0, 0}}, cube).hit);
}

TEST_CASE("box: origin inside, on a face, an edge, a corner (A03)") {
  CHECK(aabb({{0, 0, 0}, {1, 0, 0}}, cube).t.value == 1);
  CHECK(aabb({{0, 0, 0}, {1, 0, 0}}, cube).entry.value == -1);
  CHECK(aabb({{-1, 0, 0}, {1, 0, 0}}, cube).t.value == 0);
  CHECK(aabb({{1, 0, 0}, {1, 0, 0}}, cube).t.value == 0);
  CHECK(aabb({{1, 0, 0}, {-1, 0, 0}, 5e-324}, cube).t.value == 2);
  CHECK_FALSE(aabb({{1, 0, 0}, {1, 0, 0}, 5e-324}, cube).hit);
  CHECK(aabb({{1, 1, 0}, {0, 0, 1}}, cube).t.value == 1);
  CHECK(aabb({{1, 1, 1}, {1, 1, 1}}, cube).t.value == 0);
  CHECK(aabb({{1, 1, 1}, {1, -1, 0}}, cube).hit);
  // From inside, an exit beyond t_max meets no surface although the box is entered.
  CHECK_FALSE(aabb({{0, 0, 0}, {1, 0, 0}, 0, 0.5}, cube).hit);
  CHECK(aabb({{0, 0, 0}, {1, 0, 0}, 0, 0.5}, cube).overlaps);
}

TEST_CASE("box: flat, point, inverted (A04)") {
  CHECK(aabb({{0, 0, 5}, {0, 0, -1}}, {{-1, -1, 0}, {1, 1, 0}}).t.value == 5);
  CHECK(aabb({{-5, 0, 0}, {1, 0, 0}}, {{-1, -1, 0}, {1, 1, 0}}).t.value == 4);
  CHECK(aabb({{-5, -5, 0}, {1, 1, 0}}, {{-1, 0, 0}, {1, 0, 0}}).t.value == 5);
  CHECK(aabb({{0, 0, 0}, {1, 2, 3}}, {{2, 4, 6}, {2, 4, 6}}).t.value == 2);
  CHECK_FALSE(aabb({{0, 0, 0}, {1, 2, 3}}, {{2, 4, std::nextafter(6, 7)}, {2, 4, std::nextafter(6, 7)}}).hit);
  CHECK_FALSE(aabb({{-5, 0, 0}, {1, 0, 0}}, {{1, 1, 1}, {-1, -1, -1}}).line_meets);
}

TEST_CASE("box: a denormal point box is met exactly where the ray passes it (A05)") {
  const double p = static_cast<double>(5.693442e-39f);
  const Aabb point{{p, p, p}, {p, p, p}};
  CHECK_FALSE(aabb({{-5000, -5000, 5000}, {1, 1, -1}}, point).hit);
  CHECK(aabb({{p, p, 5000}, {0, 0, -1}}, point).hit);
  CHECK(aabb({{0, 0, 0}, {1, 1, 1}}, point).t.value == p);
}

TEST_CASE("box: denormal directions, huge and tiny boxes (A06, A07, A08)") {
  const AabbAnswer slow = aabb({{-3, 0, 0}, {1e-40, 0, 0}}, cube);
  CHECK(ulp_error_f64(2 / 1e-40, slow.t) <= 1);
  CHECK(aabb({{-5, 1, 0}, {1, 1e-40, 0}}, cube).line_meets == false);
  CHECK(aabb({{-5, 1, 0}, {1, -1e-40, 0}}, cube).hit);
  CHECK(aabb({{0, 0, 0}, {1, 1, 1}}, {{-1e30, -1e30, -1e30}, {1e30, 1e30, 1e30}}).t.value == 1e30);
  const AabbAnswer tiny = aabb({{-1, 0, 0}, {1, 0, 0}}, {{-1e-30, -1e-30, -1e-30}, {1e-30, 1e-30, 1e-30}});
  CHECK(tiny.t.value == 1);
  // The filter's 2^-113 of 1 shows here: t is known to 2^-80.
  CHECK(tiny.t.rest == Approx(-1e-30).epsilon(1e-3));
}

TEST_CASE("box: an empty range meets nothing (A10); corners are exact (A11), the lowest axis wins ties (A12)") {
  CHECK_FALSE(aabb({{-5, 0, 0}, {1, 0, 0}, 9, 3}, cube).hit);
  CHECK_FALSE(aabb({{-5, 0, 0}, {1, 0, 0}, 9, 3}, cube).overlaps);
  const AabbAnswer corner = aabb({{-3, -1, 1}, {1, 1, -1}}, {{-1, 1, -1}, {1, 2, 1}});
  CHECK(corner.hit);
  CHECK(corner.t.value == 2);
  CHECK(corner.entry_axis == 0);
  const AabbAnswer touch = aabb({{-3, 0, 0}, {1, 1, 0}}, {{-1, 0, -1}, {1, 2, 1}});
  CHECK(touch.t.value == 2);
  CHECK(touch.margin == 0);
  CHECK_FALSE(aabb({{-3, std::nextafter(0, 1), 0}, {1, 1, 0}}, {{-1, 0, -1}, {1, 2, 1}}).hit);
}
