// SPDX-License-Identifier: MIT
// The robust tier's t is the real nearest to the exact t, to even where two are equally near, and its bits are the same
// by every route: double words, doubles, exact decisions alone (docs/decisions/0023-correctly-rounded-t.md).
#include <algorithm>
#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>

#include "program/kernel_source.h"
#include "robust/ask_host.h"
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
