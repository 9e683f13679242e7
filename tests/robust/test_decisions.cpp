// SPDX-License-Identifier: MIT
// Exact decisions take microseconds, so rays as scenes have them must seldom need one: the walls of a needle seen along
// it, the ground of a planet seen by someone who stands on it, and what is neither.
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <random>
#include <utility>
#include <vector>

#include "robust/kernels.h"

using namespace strahl::test;

namespace {

constexpr int cases = 20000;

class Draw {
 public:
  float between(double least, double most) {
    return static_cast<float>(std::uniform_real_distribution<double>(least, most)(random_));
  }
  int below(int count) { return std::uniform_int_distribution<int>(0, count - 1)(random_); }

 private:
  std::mt19937 random_{5};
};

struct Aim {
  std::vector<float> planes;
  std::vector<float> ray;  ///< RAY_REALS of cl/scene/layout.h.
};

std::vector<float> ray_of(float ox, float oy, float oz, float dx, float dy, float dz) {
  return {ox, oy, oz, dx, dy, dz, 0.0F, INFINITY};
}

/// Share of rays for which wide arithmetic does not tell t.
double open_share(const char* kind, Route route, const std::function<Aim(Draw&)>& aim_of) {
  Draw draw;
  int open = 0;
  for (int i = 0; i < cases; ++i) {
    const Aim q = aim_of(draw);
    open += robust_is_told(kind, q.planes, q.ray, route) ? 0 : 1;
  }
  return static_cast<double>(open) / cases;
}

/// A wall of a needle 1 wide and 200,000 long, which may begin at any corner, seen from its middle.
Aim wall(Draw& draw) {
  const float tip = draw.below(2) == 0 ? 1e5F : -1e5F;
  const float corners[3][3] = {{0.5F, draw.between(-0.5, 0), 0}, {draw.between(0.3, 0.7), 0.5F, 10}, {0, 0, tip}};
  const int first = draw.below(3);
  Aim q;
  for (int k = 0; k < 3; ++k)
    for (const float x : corners[(first + k) % 3]) q.planes.push_back(x);
  q.ray = ray_of(draw.between(-0.01, 0.01), draw.between(-0.01, 0.01), 0, draw.between(0.1, 1), draw.between(-0.1, 0.1),
                 std::copysign(draw.between(1, 1e4), tip));
  return q;
}

/// A sphere as large as the Earth, seen from a few metres above it.
Aim ground(Draw& draw) {
  const float radius = 6.4e6F;
  return {{0, -radius, 0, radius},
          ray_of(draw.between(-5, 5), draw.between(0.5, 50), draw.between(-5, 5), draw.between(-1, 1),
                 draw.between(-1, -0.02), draw.between(-1, 1))};
}

Aim ball(Draw& draw) {
  return {{draw.between(-3, 3), draw.between(-3, 3), draw.between(5, 20), draw.between(0.5, 2)},
          ray_of(draw.between(-1, 1), draw.between(-1, 1), 0, draw.between(-0.3, 0.3), draw.between(-0.3, 0.3), 1)};
}

Aim polygon(Draw& draw) {
  Aim q;
  for (int i = 0; i < 9; ++i) q.planes.push_back(draw.between(-3, 3) + (i % 3 == 2 ? 12.0F : 0.0F));
  q.ray = ray_of(draw.between(-1, 1), draw.between(-1, 1), 0, draw.between(-0.3, 0.3), draw.between(-0.3, 0.3), 1);
  return q;
}

/// A triangle of a floor, and a ray that left a shape standing there: next to its plane, over or under it.
Aim floor(Draw& draw) {
  Aim q;
  const float height = draw.between(-2, 2), x = draw.between(-1, 1), z = draw.between(-1, 1);
  for (const auto& [cx, cz] : {std::pair{-9.0F, -8.0F}, {9.0F, -7.0F}, {0.5F, 9.0F}})
    q.planes.insert(q.planes.end(), {cx, height, cz});
  const float off = draw.below(2) == 0 ? draw.between(2e-7, 2e-6) : -draw.between(2e-7, 2e-6);
  q.ray = ray_of(x, height + off, z, draw.between(-1, 1), -off * draw.between(1e5, 1e6), draw.between(-1, 1));
  return q;
}

TEST_CASE("exact decisions are seldom, in doubles") {
  CHECK(open_share("triangle", Route::doubles, floor) < 0.001);
  CHECK(open_share("triangle", Route::doubles, wall) < 0.02);
  CHECK(open_share("sphere", Route::doubles, ground) < 0.002);
  CHECK(open_share("triangle", Route::doubles, polygon) < 0.001);
  CHECK(open_share("sphere", Route::doubles, ball) < 0.001);
}

TEST_CASE("exact decisions are seldom in double words, but in a needle") {
  CHECK(open_share("triangle", Route::double_words, floor) < 0.01);
  CHECK(open_share("triangle", Route::double_words, polygon) < 0.01);
  CHECK(open_share("sphere", Route::double_words, ground) < 0.05);
  CHECK(open_share("sphere", Route::double_words, ball) < 0.01);
}

TEST_CASE("without wide arithmetic every ray needs them") { CHECK(open_share("sphere", Route::exact, ball) == 1.0); }

}  // namespace
