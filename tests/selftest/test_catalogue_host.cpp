// SPDX-License-Identifier: MIT
// Every question of the catalogue, put to the robust and the double tier on the host: no wrong answer, no NaN, t within
// the bounds of docs/decisions/0007-robust-tier.md. Rows that say "once" are met exactly once.
#include <array>
#include <catch2/catch.hpp>
#include <cmath>

#include "selftest/answer.h"
#include "selftest/catalogue.h"
#include "selftest/nearest.h"

using namespace strahl;
using namespace strahl::selftest;
using namespace strahl::test;

namespace {

using Ask = Nearest (*)(std::string_view, std::span<const double>, std::span<const double>, int);

/// Bounds of t in ulps of float.
double bound(const std::string& kind) {
  if (kind == "cylinder") return 8;
  if (kind == "triangle" || kind == "parallelogram") return 4;
  return kind == "box" ? 2 : 1;
}

std::array<double, 8> reals_of(const oracle::Ray& ray) {
  return {ray.origin.x,    ray.origin.y,    ray.origin.z, ray.direction.x,
          ray.direction.y, ray.direction.z, ray.t_min,    ray.t_max};
}

int times_met(const Question& q, Ask ask) {
  const auto reals = static_cast<std::size_t>(planes_of(q.kind));
  int met = 0;
  for (std::size_t i = 0; i + reals <= q.planes.size(); i += reals)
    met += std::isfinite(ask(q.kind, std::span(q.planes).subspan(i, reals), reals_of(q.ray), -1).t);
  return met;
}

void hold(Ask ask, double largest_of(const std::string&)) {
  int asked = 0;
  for (const Row& row : catalogue()) {
    int i = 0;
    double worst = 0;
    for (const Question& q : questions_of(row)) {
      const Nearest found = ask(q.kind, q.planes, reals_of(q.ray), q.left);
      const Judgement judgement = judge(q, found.t, found.primitive);
      INFO("[" << row.id << "] " << row.title << ", question " << i << " of a " << q.kind << ": t " << found.t << " of "
               << found.primitive << "; expected t " << q.t.value << " of " << q.primitive << ", "
               << (q.expected == Expected::hit    ? "hit"
                   : q.expected == Expected::miss ? "miss"
                                                  : "either"));
      if (judgement.is_wrong) CHECK_FALSE(judgement.is_wrong);
      if (judgement.ulps > largest_of(q.kind)) CHECK(judgement.ulps <= largest_of(q.kind));
      worst = std::max(worst, judgement.ulps);
      if (row.is_once)
        if (const int met = times_met(q, ask); met != 1) CHECK(met == 1);
      ++i;
    }
    asked += i;
  }
  CHECK(asked > 1000);
}

}  // namespace

TEST_CASE("the robust tier answers every row") { hold(nearest_robust, bound); }

TEST_CASE("the double tier answers every row") {
  hold(nearest_double, [](const std::string&) { return 1.0; });
}
