// SPDX-License-Identifier: MIT
// The ball that every kind of shape states of itself (cl/shapes/ball.h) holds all of it: wherever exact arithmetic has
// a ray meet the shape, of any size and place that the generators draw, the point lies within.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <map>
#include <string>

#include "robust/ask_host.h"

using namespace strahl;
using namespace strahl::selftest;
using namespace strahl::test;
using oracle::Law;

namespace {

constexpr int cases_a_law = 4000;

/// Largest share of the ball's radius that a point of the shape lies from its centre.
struct Reach {
  int points = 0;
  double most = 0;
};

/// Places the ray's hit in 80 bits: what o + t d rounds is far below what the ball has to spare.
long double share_of_radius(const Question& q, const std::array<float, 4>& ball) {
  const auto on_ray = [&](double o, double d, float centre) {
    return (static_cast<long double>(o) - static_cast<long double>(centre)) +
           (static_cast<long double>(q.t.value) + static_cast<long double>(q.t.rest)) * static_cast<long double>(d);
  };
  const long double x = on_ray(q.ray.origin.x, q.ray.direction.x, ball[0]);
  const long double y = on_ray(q.ray.origin.y, q.ray.direction.y, ball[1]);
  const long double z = on_ray(q.ray.origin.z, q.ray.direction.z, ball[2]);
  const long double off = std::sqrt(x * x + y * y + z * z);
  return off > 0 ? off / static_cast<long double>(ball[3]) : 0;
}

Reach reach_of(const std::string& kind) {
  Reach reach;
  for (const Law law : oracle::all_laws) {
    if (law == Law::extreme) continue;
    oracle::Random random(900 + static_cast<std::uint64_t>(law));
    for (int i = 0; i < cases_a_law; ++i) {
      const Question q = draw_question(kind, law, random);
      if (q.expected != Expected::hit) continue;
      std::vector<float> planes;
      for (const double x : q.planes) planes.push_back(static_cast<float>(x));
      ++reach.points;
      reach.most = std::max(reach.most, static_cast<double>(share_of_radius(q, robust_ball(kind, planes))));
    }
  }
  return reach;
}

}  // namespace

TEST_CASE("every kind of shape lies within its ball") {
#define SHAPE(name, planes)              \
  {                                      \
    const Reach reach = reach_of(#name); \
    INFO(#name);                         \
    CHECK(reach.points > cases_a_law);   \
    CHECK(reach.most <= 1);              \
  }
#include "../../cl/shapes/shapes.def"
#undef SHAPE
}
