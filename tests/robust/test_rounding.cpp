// SPDX-License-Identifier: MIT
// The robust tier's t is the real nearest to the exact t, to even where two are equally near, and its bits are the same
// by every route: double words, doubles, exact decisions alone (docs/decisions/0023-correctly-rounded-t.md).
#include <algorithm>
#include <array>
#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "program/kernel_source.h"
#include "robust/ask_host.h"
#include "robust/kernels.h"
#include "support/asked.h"

using namespace strahl;
using namespace strahl::selftest;
using namespace strahl::test;
using oracle::Law;

namespace {

/// STRAHL_CASES, a law, takes the place of what fits a run of all tests.
int cases_per_law(int usual) { return static_cast<int>(count_asked_for("STRAHL_CASES", usual)); }

float nearest_real(const oracle::Exact& t) {
  const auto near = static_cast<float>(t.value);
  const double beyond = (t.value - near) + t.rest;
  const float other = std::nextafterf(near, beyond > 0 ? HUGE_VALF : -HUGE_VALF);
  const double gap = static_cast<double>(other) - near;
  if (2 * std::fabs(beyond) == std::fabs(gap)) return std::bit_cast<std::uint32_t>(near) % 2 == 0 ? near : other;
  return 2 * std::fabs(beyond) < std::fabs(gap) ? near : other;
}

bool are_same(float a, float b) { return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b); }

/// How often, and the first one.
struct Wrong {
  int count = 0;
  std::string first;
  void add(const Question& q, float t, float other) {
    if (count++ > 0) return;
    first = std::to_string(t) + " for " + std::to_string(other) + ":";
    for (const double x : q.planes) first += " " + std::to_string(x);
    for (const float x : reals_of(q.ray)) first += " " + std::to_string(x);
  }
};

}  // namespace

TEST_CASE("t is correctly rounded, and the same in double words and in doubles") {
  for (const std::string& kind : list_entries("shapes"))
    for (const Law law : oracle::all_laws) {
      oracle::Random random(200 + static_cast<std::uint64_t>(law));
      Wrong rounded, by_route;
      for (int i = 0; i < cases_per_law(20000); ++i) {
        const Question q = draw_question(kind, law, random);
        const float t = ask_host(q), other = ask_host(q, Route::doubles);
        if (!are_same(t, other)) by_route.add(q, t, other);
        if (law == Law::extreme || q.expected != Expected::hit || !std::isfinite(t)) continue;
        if (t != nearest_real(q.t)) rounded.add(q, t, nearest_real(q.t));
      }
      INFO(kind << ", law " << static_cast<int>(law) << ": " << rounded.first << "; " << by_route.first);
      CHECK(rounded.count == 0);
      CHECK(by_route.count == 0);
    }
}

/// A ray that begins in the plane of a polygon or next to it, within its edges or not, from 0 on or from a little
/// later. Some planes are parallel to an axis, exactly or all but.
std::pair<std::vector<float>, std::vector<float>> skimming_question(int corners, std::mt19937& random) {
  const auto between = [&](double least, double most) {
    return static_cast<float>(std::uniform_real_distribution<double>(least, most)(random));
  };
  const auto below = [&](int count) { return std::uniform_int_distribution<int>(0, count - 1)(random); };
  const int axis = below(3), tilt = below(3);
  const float height = below(2) == 0 ? 0.0F : between(-3, 3), scale = std::ldexp(1.0F, below(40) - 20);
  const auto placed = [&](float u, float v, float h) {
    std::array<float, 3> p{};
    p[axis] = scale * h;
    p[(axis + 1) % 3] = scale * u;
    p[(axis + 2) % 3] = scale * v;
    return p;
  };
  const float slope = tilt == 0 ? 0.0F : tilt == 1 ? between(-1e-7, 1e-7) : between(-1, 1);
  std::vector<float> planes;
  const std::array<std::array<float, 2>, 4> of_corners = {{{-2, -3}, {4, -3}, {4, 2}, {-2, 2}}};
  for (int k = 0; k < corners; ++k) {
    const auto [u, v] = of_corners[static_cast<std::size_t>(k)];
    const auto p = placed(u, v, height + slope * u);
    planes.insert(planes.end(), p.begin(), p.end());
  }
  const float u = between(-2.2, 4.2), v = between(-3.2, 2.2);
  const float off = below(3) == 0 ? 0.0F : std::ldexp(between(-1, 1), -below(below(4) == 0 ? 140 : 60));
  const auto o = placed(u, v, height + slope * u + off), d = placed(between(-1, 1), between(-1, 1), between(-1, 1));
  const float t_min = below(2) == 0 ? 0.0F : std::ldexp(1.0F, -below(30));
  return {planes, {o[0], o[1], o[2], d[0], d[1], d[2], t_min, HUGE_VALF}};
}

TEST_CASE("rays that begin next to a polygon's plane have the same t by every route") {
  std::mt19937 random(7);
  for (const auto& [kind, corners] : {std::pair{"triangle", 3}, {"parallelogram", 4}}) {
    int hits = 0, wrong = 0;
    for (int i = 0; i < cases_per_law(20000); ++i) {
      const auto [planes, ray] = skimming_question(corners, random);
      const float t = robust_t(kind, planes, ray, false, Route::exact);
      hits += std::isfinite(t) ? 1 : 0;
      for (const Route route : {Route::doubles, Route::double_words})
        wrong += are_same(t, robust_t(kind, planes, ray, false, route)) ? 0 : 1;
    }
    CHECK(8 * hits > cases_per_law(20000));
    CHECK(wrong == 0);
  }
}

// The low word of the quotient of double words is rounded as numbers of 2^-149 are: to a tie here.
TEST_CASE("a tiny t next to a tie is the same by every route") {
  const std::vector<float> planes = {0, 0, 0, 0x1p15F, 0x1.000002p15F, 0, 0, 0, 0x1p15F};
  const std::vector<float> ray = {0x1.800002p-120F, 0, 0x1p-120F, 0, 1, 0, 0, HUGE_VALF};
  for (const Route route : {Route::doubles, Route::double_words, Route::exact})
    CHECK(robust_t("triangle", planes, ray, false, route) == 0x1.800006p-120F);
}

TEST_CASE("exact decisions alone say the same") {
  for (const std::string& kind : list_entries("shapes"))
    for (const Law law : oracle::all_laws) {
      oracle::Random random(300 + static_cast<std::uint64_t>(law));
      Wrong differ;
      for (int i = 0; i < cases_per_law(400); ++i) {
        const Question q = draw_question(kind, law, random);
        const float t = ask_host(q), exact = ask_host(q, Route::exact);
        if (!are_same(t, exact)) differ.add(q, t, exact);
      }
      INFO(kind << ", law " << static_cast<int>(law) << ": " << differ.first);
      CHECK(differ.count == 0);
    }
}
