// SPDX-License-Identifier: MIT
// The robust tier against exact arithmetic, every kind of shape by every law of the generators: no wrong hit or miss
// outside the bands of selftest/questions.cpp, and t correctly rounded, at every ratio and grazing angle.
// docs/decisions/0007-robust-tier.md states the bands. Left out: the law `extreme`, whose products leave the range of
// float.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <string>

#include "program/kernel_source.h"
#include "robust/ask_host.h"
#include "support/asked.h"

using namespace strahl;
using namespace strahl::selftest;
using namespace strahl::test;
using oracle::Law;

namespace {

/// STRAHL_CASES takes the place of what fits a run of all tests.
int cases_per_law() { return static_cast<int>(count_asked_for("STRAHL_CASES", 20000)); }

void hold(const std::string& kind, int cases) {
  int decided = 0, hits = 0;
  double worst_of_all = 0;
  for (const Law law : oracle::all_laws) {
    if (law == Law::extreme) continue;
    oracle::Random random(100 + static_cast<std::uint64_t>(law));
    int wrong = 0;
    double worst = 0;
    for (int i = 0; i < cases; ++i) {
      const Question q = draw_question(kind, law, random);
      const float t = ask_host(q);
      const Judgement judgement = judge(q, t, std::isfinite(t) ? 0 : -1);
      if (judgement.is_nan) FAIL(kind << ", law " << static_cast<int>(law) << ", case " << i << ": NaN");
      decided += q.expected != Expected::either;
      hits += q.expected == Expected::hit;
      wrong += judgement.is_wrong;
      worst = std::max(worst, judgement.ulps);
    }
    INFO(kind << ", law " << static_cast<int>(law));
    CHECK(wrong == 0);
    CHECK(worst <= 0.5);
    worst_of_all = std::max(worst_of_all, worst);
  }
  // So that leaving out cannot swallow the test.
  CHECK(decided > 2 * cases);
  CHECK(2 * hits > 3 * cases);
  WARN(kind << ": " << decided << " decided, " << hits << " hits, largest error " << worst_of_all << " ulp");
}

}  // namespace

TEST_CASE("no wrong hit, and t to the last place") {
  for (const std::string& kind : list_entries("shapes")) hold(kind, cases_per_law());
}

TEST_CASE("the settings that break single precision in its usual forms") {
  struct Setting {
    double radius, distance;
  };
  for (const auto& [radius, away] : {Setting{1, 10}, Setting{1, 1e3}, Setting{1, 1e4}, Setting{1, 1e6},
                                     Setting{1e-3, 1e4}, Setting{1e6, 2e6}, Setting{6.4e6, 6.4e6 + 2}}) {
    INFO("radius " << radius << " at " << away);
    oracle::Random random(7);
    int wrong = 0, hits = 0;
    double worst = 0;
    for (int i = 0; i < 20000; ++i) {
      const auto direction = [&] {
        return normalized(Vec3{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)});
      };
      Question q;
      q.kind = "sphere";
      const Vec3 to_center = direction(), n = normalized(cross(to_center, direction()));
      const oracle::Sphere sphere{{0, 0, 0}, to_float(radius)};
      put(q.planes, sphere.center);
      q.planes.push_back(to_float(radius));
      const Vec3 origin = -away * to_center;
      // Within the disc that it shows, or within 2^-23 ... 2^-10 of its silhouette.
      const double silhouette = radius * (1 + random.sign() * std::ldexp(1.0, -random.integer(10, 23)));
      const double aside = i % 2 ? radius * random.uniform(0, 1) : std::min(silhouette, away * 0.999999);
      const Vec3 d = std::sqrt(1 - (aside / away) * (aside / away)) * to_center + aside / away * n;
      q.ray.origin = {to_float(origin.x), to_float(origin.y), to_float(origin.z)};
      q.ray.direction = {to_float(d.x), to_float(d.y), to_float(d.z)};
      const auto answer = oracle::sphere(q.ray, sphere);
      settle(q, answer, std::fabs(answer.margin) > 4 * u);
      const float t = ask_host(q);
      const Judgement judgement = judge(q, t, std::isfinite(t) ? 0 : -1);
      wrong += judgement.is_wrong;
      hits += q.expected == Expected::hit;
      worst = std::max(worst, judgement.ulps);
    }
    CHECK(wrong == 0);
    CHECK(worst <= 0.5);
    CHECK(hits > 5000);
  }
}

TEST_CASE("disks far larger than the way to their plane, nearly along it") {
  // n.d has nothing in single precision but rounding, which makes t any number.
  oracle::Random random(13);
  int wrong = 0, hits = 0, misses = 0;
  for (int i = 0; i < 20000; ++i) {
    const auto part = [&] { return to_float(random.uniform(-1, 1)); };
    const Vec3 n{1, part(), part()}, along_u{n.y, -1, 0}, along_v{n.z, 0, -1};
    const double height = std::pow(10, random.uniform(-5, -2));
    Question q;
    q.kind = "disk";
    put(q.planes, Vec3{0, 0, 0});
    put(q.planes, n);
    q.planes.push_back(to_float(std::pow(height * std::pow(10, random.uniform(8, 11)), 2)));
    q.ray.origin = {to_float(height), 0, 0};
    do {
      const Vec3 d = random.uniform(-1, 1) * along_u + random.uniform(-1, 1) * along_v;
      q.ray.direction = {to_float(d.x), to_float(d.y), to_float(d.z)};
    } while (std::fabs(dot(n, q.ray.direction)) > 1e-10);
    const auto answer = oracle::disk(q.ray, {{0, 0, 0}, along_u, along_v, std::sqrt(q.planes.back())});
    settle(q, answer, std::fabs(answer.margin) > 1e-3);
    const float t = ask_host(q);
    wrong += judge(q, t, std::isfinite(t) ? 0 : -1).is_wrong;
    hits += q.expected == Expected::hit;
    misses += q.expected == Expected::miss;
  }
  CHECK(wrong == 0);
  CHECK(hits > 2000);
  CHECK(misses > 2000);
}

TEST_CASE("needles: a triangle's t is measured from the corner where least cancels") {
  oracle::Random random(11);
  int wrong = 0, hits = 0;
  double worst = 0;
  for (int i = 0; i < 20000; ++i) {
    const auto near = [&] { return Vec3{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)}; };
    const Vec3 tip = std::pow(10, random.uniform(1, 5)) * normalized(near());
    std::array<Vec3, 3> corners{tip, near(), near()};
    std::rotate(corners.begin(), corners.begin() + i % 3, corners.end());
    Question q;
    q.kind = "triangle";
    for (const Vec3& corner : corners) put(q.planes, corner);
    const auto at = [&q](std::size_t k) { return Vec3{q.planes[k], q.planes[k + 1], q.planes[k + 2]}; };
    const oracle::Triangle triangle{at(0), at(3), at(6)};
    // Near the base, where the needle is 1 wide.
    const double along = random.uniform(0, 1 / length(tip)), beside = random.uniform(0, 1);
    const Vec3 base = beside * corners[(4 - i % 3) % 3] + (1 - beside) * corners[(5 - i % 3) % 3];
    const Vec3 origin = near(), target = along * tip + (1 - along) * base;
    q.ray.origin = {to_float(origin.x), to_float(origin.y), to_float(origin.z)};
    const Vec3 d = target - q.ray.origin;
    q.ray.direction = {to_float(d.x), to_float(d.y), to_float(d.z)};
    const auto answer = oracle::triangle(q.ray, triangle);
    settle(q, answer, answer.cosine >= 1e-3 && std::fabs(answer.margin) > 8 * u);
    const float t = ask_host(q);
    const Judgement judgement = judge(q, t, std::isfinite(t) ? 0 : -1);
    wrong += judgement.is_wrong;
    hits += q.expected == Expected::hit;
    worst = std::max(worst, judgement.ulps);
  }
  CHECK(wrong == 0);
  CHECK(worst <= 0.5);
  CHECK(hits > 5000);
}
