// SPDX-License-Identifier: MIT
// Every question of the catalogue, put to the robust and the double tier on the host: no wrong answer, no NaN, t within
// the bounds. Rows that say "once" are met exactly once, whichever primitive is asked. 3 s.
#include <array>
#include <catch2/catch.hpp>
#include <cmath>

#include "packing/pack_shapes.h"
#include "selftest/catalogue_questions.h"
#include "selftest/nearest.h"

using namespace strahl;
using namespace strahl::selftest;
using namespace strahl::test;

namespace {

using Ask = Nearest (*)(std::string_view, std::span<const double>, std::span<const double>, int);

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

void hold(const AskedByRow& asked, Ask ask, double bound(const std::string&)) {
  const Question& q = asked.question;
  const Nearest found = ask(q.kind, q.planes, reals_of(q.ray), q.left);
  if (const std::string wrong = fault(asked, found.t, found.primitive, bound(q.kind)); !wrong.empty())
    FAIL_CHECK(wrong);
  if (!asked.row->is_once) return;
  if (const int met = times_met(q, ask); met != 1)
    FAIL_CHECK("[" << asked.row->id << "] question " << asked.number << ": met " << met << " times");
}

}  // namespace

TEST_CASE("the robust and the double tier answer every row") {
  const std::vector<AskedByRow> all = all_questions();
  CHECK(all.size() > 40000);
  int decided = 0;
  for (const AskedByRow& asked : all) {
    decided += asked.question.expected != Expected::either;
    hold(asked, nearest_robust, robust_bound);
    hold(asked, nearest_double, double_bound);
  }
  // So that leaving open cannot swallow the test.
  CHECK(10 * decided > 8 * static_cast<int>(all.size()));
  WARN(all.size() << " questions, " << decided << " of them decided");
}
