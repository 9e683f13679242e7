// SPDX-License-Identifier: MIT
// Triangles on PoCL where no band is granted. Along an axis, through small integers, shearing rounds nothing: hit and
// miss must be exact although twice the area beside an edge is 1 and the products that cancel there are 2^44. And a ray
// in the triangle's own plane, if it hits, hits between the vertices. 1 s.
#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>

#include "oracle/random.h"
#include "selftest/probe.h"
#include "support/devices.h"

using namespace strahl;
using namespace strahl::selftest;
using namespace strahl::test;

namespace {

/// x, y with a x + b y = 1, |x| and |y| at most |a| and |b|; a and b positive and coprime.
std::pair<long, long> bezout(long a, long b) {
  if (b == 0) return {1, 0};
  const auto [x, y] = bezout(b, a % b);
  return {y, x - a / b * y};
}

/// The ray passes the edge from (p, q) to (-p, -q) + (x, y) with twice the area p y - q x = +-1 on one side of it, and
/// the third vertex stands on either.
Question beside_an_edge(oracle::Random& random) {
  long p, q;
  do {
    p = random.integer(1 << 20, 1 << 22);
    q = random.integer(1 << 20, 1 << 22);
  } while (std::gcd(p, q) != 1);
  auto [y, minus_x] = bezout(p, q);  // p y - q x = 1
  long x = -minus_x, area = 1;
  if (random.integer(0, 1) == 0) x = -x, y = -y, area = -1;
  const long side = random.integer(0, 1) == 0 ? 1 : -1;
  Question question;
  question.kind = "triangle";
  const auto vertex = [&](long vx, long vy) {
    for (const long coordinate : {vx, vy, 0L}) question.planes.push_back(static_cast<double>(coordinate));
  };
  vertex(p, q);
  vertex(x - p, y - q);
  vertex(side * q, -side * p);
  question.ray = {{0, 0, -8}, {0, 0, 1}};
  question.expected = area == side ? Expected::hit : Expected::miss;
  question.primitive = area == side ? 0 : -1;
  question.t = {8, 0};
  return question;
}

double component(const Vec3& v, int axis) { return axis == 0 ? v.x : (axis == 1 ? v.y : v.z); }

/// Corners o + s d + w e, rounded.
Question within_the_plane(oracle::Random& random) {
  const auto any = [&] { return Vec3{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)}; };
  const auto narrow = [](double x) {
    const volatile float f = static_cast<float>(x);
    return static_cast<double>(f);
  };
  const auto narrow_all = [&](const Vec3& v) { return Vec3{narrow(v.x), narrow(v.y), narrow(v.z)}; };
  Question question;
  question.kind = "triangle";
  question.ray = {narrow_all(any()), narrow_all(any())};
  const Vec3 e = any();
  for (int i = 0; i < 3; ++i) {
    const Vec3 at =
        narrow_all(question.ray.origin + random.uniform(1, 3) * question.ray.direction + random.uniform(-1, 1) * e);
    question.planes.insert(question.planes.end(), {at.x, at.y, at.z});
  }
  return question;
}

/// t between the vertices along the ray's largest axis, within the rounding of difference and quotient, and in the
/// robust tier as much again, so that no t of a true hit is moved.
bool is_between(const Question& question, double t) {
  const Vec3 &d = question.ray.direction, &o = question.ray.origin;
  int axis = 0;
  for (const int other : {1, 2})
    if (std::fabs(component(d, other)) > std::fabs(component(d, axis))) axis = other;
  double low = INFINITY, high = -INFINITY;
  for (std::size_t i = 0; i < 3; ++i) {
    const double at =
        (question.planes[3 * i + static_cast<std::size_t>(axis)] - component(o, axis)) / component(d, axis);
    low = std::min(low, at);
    high = std::max(high, at);
  }
  const double slack = 8 * 0x1p-24 * std::max(std::fabs(low), std::fabs(high));
  return low - slack <= t && t <= high + slack;
}

}  // namespace

TEST_CASE("beside an edge hit and miss are exact") {
  require_pocl();
  oracle::Random random(11);
  std::vector<Question> questions;
  for (int i = 0; i < 20000; ++i) questions.push_back(beside_an_edge(random));
  for (const Precision precision : {Precision::stable, Precision::robust}) {
    const std::vector<Answer> answers = Probe(Device::open("pocl"), "triangle", precision).ask(questions);
    int wrong = 0, hits = 0;
    for (std::size_t i = 0; i < answers.size(); ++i) {
      wrong += judge(questions[i], answers[i].t, answers[i].primitive).is_wrong;
      hits += questions[i].expected == Expected::hit;
    }
    INFO(precision_name(precision));
    CHECK(wrong == 0);
    CHECK(hits > 8000);
  }
}

TEST_CASE("a ray within the plane hits between the vertices") {
  require_pocl();
  oracle::Random random(12);
  std::vector<Question> questions;
  for (int i = 0; i < 20000; ++i) questions.push_back(within_the_plane(random));
  for (const Precision precision : {Precision::stable, Precision::robust}) {
    const std::vector<Answer> answers = Probe(Device::open("pocl"), "triangle", precision).ask(questions);
    int outside = 0, hits = 0;
    for (std::size_t i = 0; i < answers.size(); ++i) {
      if (answers[i].primitive < 0) continue;
      ++hits;
      outside += !is_between(questions[i], answers[i].t);
    }
    INFO(precision_name(precision));
    CHECK(outside == 0);
    CHECK(hits > 200);
  }
}
