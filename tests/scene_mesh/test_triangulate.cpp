// SPDX-License-Identifier: MIT
// Ear clipping: areas, orientation, collinear corners, keyholes, degenerate and crossing polygons, exact decisions.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <random>
#include <set>

#include "scene/meshes/triangulate.h"

namespace strahl {
namespace {

using Triangles = std::vector<std::array<int, 3>>;

Vec3 doubled_area(const std::vector<Vec3>& p, const std::array<int, 3>& t) {
  const auto at = [&](int i) { return p[static_cast<std::size_t>(i)]; };
  return cross(at(t[1]) - at(t[0]), at(t[2]) - at(t[0]));
}

/// The triangles cover the polygon exactly when each is oriented as it and their areas add up to its area.
void check_cover(const std::vector<Vec3>& polygon, std::size_t expected_triangles) {
  Triangles triangles;
  REQUIRE(triangulate(polygon, triangles));
  CHECK(triangles.size() == expected_triangles);
  Vec3 whole;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    whole = whole + cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]);
  }
  double sum = 0;
  for (const auto& t : triangles) {
    const Vec3 area = doubled_area(polygon, t);
    CHECK(dot(area, whole) > 0);
    sum += length(area);
  }
  CHECK(sum == Approx(length(whole)).epsilon(1e-12));
}

TEST_CASE("a convex polygon becomes the fan of its first corner") {
  Triangles triangles;
  REQUIRE(triangulate(std::vector<Vec3>{{0, 0, 0}, {2, 0, 0}, {3, 1, 0}, {2, 2, 0}, {0, 2, 0}}, triangles));
  CHECK(triangles == Triangles{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}});
}

TEST_CASE("a concave quad is split at its reflex corner, wherever that stands") {
  const std::vector<Vec3> dart{{0, 0, 1}, {4, 0, 1}, {1, 1, 1}, {0, 4, 1}};
  for (std::size_t shift = 0; shift < 4; ++shift) {
    std::vector<Vec3> turned;
    for (std::size_t i = 0; i < 4; ++i) turned.push_back(dart[(i + shift) % 4]);
    check_cover(turned, 2);
  }
}

TEST_CASE("collinear corners are kept, so that neighbours meet without T-junctions") {
  const std::vector<Vec3> square{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0},
                                 {2, 2, 0}, {1, 2, 0}, {0, 2, 0}, {0, 1, 0}};
  check_cover(square, 6);
  Triangles triangles;
  REQUIRE(triangulate(square, triangles));
  std::set<int> used;
  for (const auto& t : triangles) used.insert(t.begin(), t.end());
  CHECK(used.size() == 8);
}

TEST_CASE("a corner on the cut blocks an ear") { check_cover({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 1, 0}}, 2); }

TEST_CASE("a keyhole leaves the hole open") {
  // A square with a square hole, joined by the doubled edge 0-4.
  const std::vector<Vec3> ring{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {0, 0, 0},
                               {1, 1, 0}, {1, 3, 0}, {3, 3, 0}, {3, 1, 0}, {1, 1, 0}};
  check_cover(ring, 8);
  Triangles triangles;
  REQUIRE(triangulate(ring, triangles));
  double area = 0;
  for (const auto& t : triangles) {
    area += doubled_area(ring, t).z / 2;
    const auto at = [&](int i) { return ring[static_cast<std::size_t>(i)]; };
    const Vec3 middle = (1.0 / 3) * (at(t[0]) + at(t[1]) + at(t[2]));
    const bool in_hole = middle.x > 1 && middle.x < 3 && middle.y > 1 && middle.y < 3;
    CHECK_FALSE(in_hole);
  }
  CHECK(area == 12);
}

TEST_CASE("a spiral of very many corners takes moments") {
  // A band of ten rounds, along its outer edge and back: of all corners only those at the two ends are ears at first.
  std::vector<Vec3> band;
  constexpr int steps = 50000;
  const auto add = [&](int i, double width) {
    const double turns = 10.0 * i / steps, angle = 2 * std::numbers::pi * turns;
    band.push_back({(1 + turns + width) * std::cos(angle), (1 + turns + width) * std::sin(angle), 0});
  };
  for (int i = 0; i <= steps; ++i) add(i, 0.5);
  for (int i = steps; i >= 0; --i) add(i, 0);
  check_cover(band, band.size() - 2);
}

TEST_CASE("a disc of very many corners takes moments, with a notch, too") {
  for (const bool has_notch : {false, true}) {
    std::vector<Vec3> disc;
    constexpr int corners = 300000;
    for (int i = 0; i < corners; ++i) {
      const double angle = 2 * std::numbers::pi * i / corners, radius = has_notch && i == corners / 2 ? 0.5 : 1;
      disc.push_back({radius * std::cos(angle), radius * std::sin(angle), 0});
    }
    Triangles triangles;
    REQUIRE(triangulate(disc, triangles));
    CHECK(triangles.size() == disc.size() - 2);
  }
}

TEST_CASE("a repeated corner is left out") {
  Triangles triangles;
  REQUIRE(triangulate(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}}, triangles));
  CHECK(triangles == Triangles{{0, 1, 3}});
}

TEST_CASE("without area or with crossing edges: nothing is added") {
  Triangles triangles{{7, 8, 9}};
  CHECK_FALSE(triangulate(std::vector<Vec3>{{0, 0, 0}, {1, 1, 1}, {3, 3, 3}}, triangles));
  CHECK_FALSE(triangulate(std::vector<Vec3>{{1, 2, 3}, {1, 2, 3}, {4, 5, 6}}, triangles));
  CHECK_FALSE(triangulate(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}, triangles));
  CHECK_FALSE(triangulate(std::vector<Vec3>{{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 2, 0}}, triangles));
  CHECK_FALSE(triangulate(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}}, triangles));
  CHECK_FALSE(triangulate(std::vector<Vec3>{}, triangles));
  CHECK(triangles == Triangles{{7, 8, 9}});
}

TEST_CASE("degenerate is decided exactly, at every scale") {
  // (0.1, 0.1), (0.2, 0.2), (0.3, 0.3): doubles on the diagonal are collinear although 0.1 + 0.2 != 0.3.
  Triangles triangles;
  for (int exponent : {-1000, -300, 0, 300, 1000}) {
    const double s = std::ldexp(1.0, exponent);
    const auto p = [&](double x, double y) { return Vec3{s * x, s * y, s}; };
    CHECK_FALSE(triangulate(std::vector<Vec3>{p(0.1, 0.1), p(0.2, 0.2), p(0.3, 0.3)}, triangles));
    const double up = std::nextafter(0.3, 1);
    CHECK(triangulate(std::vector<Vec3>{p(0.1, 0.1), p(0.2, 0.2), p(0.3, up)}, triangles));
    CHECK(triangulate(std::vector<Vec3>{p(0, 0), p(1, 0), p(0.25, 0.25), p(0, 1)}, triangles));
  }
}

TEST_CASE("random star-shaped polygons in random planes are covered") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int trial = 0; trial < 500; ++trial) {
    const Vec3 n = normalized({uniform(random) - 0.5, uniform(random) - 0.5, uniform(random) - 0.4});
    const auto [s, t] = orthonormal_basis(n);
    const int corners = 4 + static_cast<int>(uniform(random) * 60);
    std::vector<Vec3> polygon;
    for (int i = 0; i < corners; ++i) {
      const double angle = 2 * std::numbers::pi * (i + 0.9 * uniform(random)) / corners;
      const double radius = 0.05 + uniform(random);
      polygon.push_back(Vec3{100, -20, 3} + radius * std::cos(angle) * s + radius * std::sin(angle) * t);
    }
    check_cover(polygon, static_cast<std::size_t>(corners) - 2);
  }
}

TEST_CASE("the normal of a triangle survives tiny, huge and thin ones") {
  for (double s : {1e-300, 1e-20, 1.0, 1e150, 1e307}) {
    CHECK(triangle_normal({0, 0, 0}, {s, 0, 0}, {0, s, 0}) == Vec3{0, 0, 1});
  }
  const Vec3 n = triangle_normal({0, 0, 0}, {1, 0, 0}, {1, 1e-320, 0});
  CHECK(length(n) == Approx(1));
  CHECK(n.x == 0);
}

}  // namespace
}  // namespace strahl
