// SPDX-License-Identifier: MIT
// Planes, triangles, parallelograms and disks worked by hand, and catalogue rows PL01-PL05, PL10, PL11, T07, T08, T11,
// T12, T17, T19.
#include <catch2/catch.hpp>
#include <cmath>

#include "oracle/oracle.h"

using namespace strahl::oracle;

namespace {

const Plane ground{{0, 0, 0}, {0, 1, 0}};
const Triangle half{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
const Parallelogram square{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
const Disk coin{{0, 0, 0}, {5, 0, 0}, {0, 5, 0}, 5};

Ray down_at(double x, double y) { return {{x, y, 3}, {0, 0, -1}}; }

}  // namespace

TEST_CASE("plane from above, below and beside") {
  CHECK(plane({{7, 3, 2}, {0, -1, 0}}, ground).t.value == 3);
  CHECK(plane({{7, -3, 2}, {0, 1, 0}}, ground).t.value == 3);
  CHECK_FALSE(plane({{7, 3, 2}, {0, 1, 0}}, ground).hit);
  CHECK(plane({{7, 3, 2}, {0, -1, 0}}, ground).margin == 1);
  CHECK(plane({{0, 1, 0}, {1, -1, 0}}, ground).margin == Approx(std::sqrt(0.5)));
}

TEST_CASE("plane: parallel rays miss, also within it (PL01, PL02)") {
  CHECK_FALSE(plane({{0, 1, 0}, {1, 0, 0}}, ground).hit);
  CHECK_FALSE(plane({{0, 0, 0}, {1, 0, 0}}, ground).hit);
  CHECK(plane({{0, 1, 0}, {1, 0, 0}}, ground).margin == 0);
  // n . d = 2^-60, which double arithmetic rounds to 0: not parallel.
  const Answer almost = plane({{0, 0, 0}, {-1 + 0x1p-30, 1, 0}}, {{1, 0, 0}, {-1 - 0x1p-30, -1, 0}});
  CHECK(almost.t.value == 0x1p60 * (1 + 0x1p-30));
  CHECK_FALSE(plane({{0, 0, 0}, {0, 0, 0}}, ground).hit);
}

TEST_CASE("plane: grazing rays have a finite exact t (PL03), t above t_max misses (PL04)") {
  for (const double tilt : {1e-7, 1e-20, 5e-324}) {
    CHECK(ulp_error_f64(0.5 / tilt, plane({{0, 0.5, 0}, {1, -tilt, 0}}, ground).t) <= 1);
  }
  CHECK_FALSE(plane({{0, 1, 0}, {1, -1e-20, 0}, 0, 1e19}, ground).hit);
}

TEST_CASE("plane: the normal's length and orientation do not matter (PL10, PL11)") {
  for (const double length : {1e-10, -1e-10, 1e10, -1e10})
    CHECK(plane({{0, 1e-6, 0}, {0, -1, 0}}, {{5, 0, 9}, {0, length, 0}}).t.value == 1e-6);
}

TEST_CASE("plane: an origin in the plane is at t = 0, a range that excludes 0 misses") {
  CHECK(plane({{1, 0, 1}, {0, 1, 0}}, ground).t.value == 0);
  CHECK_FALSE(plane({{1, 0, 1}, {0, 1, 0}, 5e-324}, ground).hit);
}

TEST_CASE("triangle: inside, outside, both faces (T19)") {
  const PlanarAnswer inside = triangle(down_at(0.25, 0.5), half);
  CHECK(inside.hit);
  CHECK(inside.t.value == 3);
  CHECK(inside.u == 0.25);
  CHECK(inside.v == 0.5);
  CHECK(inside.cosine == 1);
  CHECK(inside.margin > 0);
  CHECK_FALSE(inside.on_edge);
  CHECK(triangle({{0.25, 0.5, -3}, {0, 0, 2}}, half).t.value == 1.5);
  CHECK(triangle({{0.25, 0.5, -3}, {0, 0, 2}}, half).u == 0.25);
  const PlanarAnswer outside = triangle(down_at(0.5, 0.75), half);
  CHECK_FALSE(outside.hit);
  CHECK(outside.margin < 0);
  CHECK(outside.edge_sign[0] == -1);
  CHECK(outside.edge_sign[1] == 1);
  CHECK_FALSE(triangle({{0.25, 0.5, -3}, {0, 0, -1}}, half).hit);
}

TEST_CASE("triangle: edges and vertices belong to it, the next number outside does not") {
  const PlanarAnswer edge = triangle(down_at(0.5, 0.5), half);
  CHECK(edge.hit);
  CHECK(edge.on_edge);
  CHECK_FALSE(edge.on_vertex);
  CHECK(edge.margin == 0);
  CHECK_FALSE(triangle(down_at(0.5, std::nextafter(0.5, 1)), half).hit);
  CHECK_FALSE(triangle(down_at(-5e-324, 0.5), half).hit);
  const PlanarAnswer vertex = triangle(down_at(1, 0), half);
  CHECK(vertex.hit);
  CHECK(vertex.on_vertex);
  CHECK_FALSE(triangle(down_at(std::nextafter(1, 2), 0), half).on_vertex);
}

TEST_CASE("triangle without area is never met (T07), nor is pbrt's bad case (T08)") {
  CHECK_FALSE(triangle(down_at(0.5, 0), {{0, 0, 0}, {1, 0, 0}, {0.5, 0, 0}}).hit);
  CHECK_FALSE(triangle(down_at(0, 0), {{0, 0, 0}, {0, 0, 0}, {1, 0, 0}}).hit);
  CHECK_FALSE(triangle(down_at(0, 0), {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}).hit);
  const auto f32 = [](float x) { return static_cast<double>(x); };
  const double x = f32(-1113.45459f), z = f32(-56.2431908f);
  const Triangle sliver{{x, f32(-79.049614f), z}, {x, f32(-87.0922699f), z}, {x, f32(-79.2090149f), z}};
  const Ray ray{{f32(-1081.47925f), f32(99.9999542f), f32(87.7701111f)},
                {f32(-32.1072998f), f32(-183.355865f), f32(-144.607635f)},
                0,
                f32(.9999f)};
  CHECK_FALSE(triangle(ray, sliver).hit);
  CHECK(triangle(ray, sliver).is_parallel);
}

TEST_CASE("triangle: rays in its plane miss (T11), origins on it are at t = 0 (T12)") {
  CHECK_FALSE(triangle({{-1, 0.25, 0}, {1, 0, 0}}, half).hit);
  CHECK_FALSE(triangle({{-1, 0, 0}, {1, 0, 0}}, half).hit);
  CHECK(triangle({{0.25, 0.25, 0}, {0, 0, 1}}, half).t.value == 0);
  CHECK(triangle({{0.5, 0, 0}, {1, 1, 1}}, half).on_edge);
  CHECK(triangle({{0, 0, 0}, {1, 1, 1}}, half).on_vertex);
}

TEST_CASE("triangle: signed zeros and denormals in the direction change nothing (T17)") {
  CHECK(triangle({{0.25, 0.5, 3}, {-0.0, 0.0, -1}}, half).t.value == 3);
  CHECK(triangle({{0, 0.5, 3}, {5e-324, 0.0, -1}}, half).hit);
  CHECK_FALSE(triangle({{0, 0.5, 3}, {-5e-324, 0.0, -1}}, half).hit);
}

TEST_CASE("parallelogram: inside, borders, corners, outside") {
  CHECK(parallelogram(down_at(0.75, 0.75), square).hit);
  CHECK(parallelogram(down_at(1, 0.5), square).on_edge);
  CHECK(parallelogram(down_at(1, 0.5), square).edge_sign == std::array{1, 0, 1, 1});
  for (const double x : {0.0, 1.0}) {
    for (const double y : {0.0, 1.0}) CHECK(parallelogram(down_at(x, y), square).on_vertex);
    CHECK_FALSE(parallelogram(down_at(x, std::nextafter(1, 2)), square).hit);
    CHECK_FALSE(parallelogram(down_at(std::nextafter(x, 4 * x - 2), 0.5), square).hit);
  }
  CHECK_FALSE(parallelogram({{-1, 0.5, 0}, {1, 0, 0}}, square).hit);
  const Parallelogram slanted{{1, 1, 0}, {2, 0, 0}, {2, 2, 0}};
  CHECK(parallelogram(down_at(4, 2.5), slanted).u == 0.75);
  CHECK(parallelogram(down_at(4, 2.5), slanted).v == 0.75);
  CHECK_FALSE(parallelogram(down_at(1.5, 2), slanted).hit);
}

TEST_CASE("disk: inside, exactly on the rim, outside, in its plane") {
  CHECK(disk(down_at(1, 1), coin).t.value == 3);
  CHECK(disk(down_at(1, 1), coin).margin == Approx(1 - 2.0 / 25));
  CHECK(disk(down_at(3, 4), coin).hit);
  CHECK(disk(down_at(-4, 3), coin).margin == 0);
  CHECK_FALSE(disk(down_at(3, std::nextafter(4, 5)), coin).hit);
  CHECK_FALSE(disk({{-9, 0, 0}, {1, 0, 0}}, coin).hit);
  CHECK_FALSE(disk({{0, 0, 3}, {0, 0, 0}}, coin).hit);
  CHECK_FALSE(disk(down_at(0, 0), {{0, 0, 0}, {5, 0, 0}, {0, 5, 0}, 0}).hit);
  // The radius alone says how large it is; the axes only span the plane.
  CHECK(disk(down_at(3, 4), {{0, 0, 0}, {1, 0, 0}, {1, 1e-3, 0}, 5}).hit);
}
