// SPDX-License-Identifier: MIT
// How many samples come next: towards a number, a deadline, an error.
#include <catch2/catch.hpp>
#include <limits>

#include "render/pass_plan.h"

namespace strahl {
namespace {

ErrorEstimate error_of(double rmse) { return {rmse, 0.9 * rmse, 1.05 * rmse, 0}; }

TEST_CASE("a number of samples is one pass") {
  PassPlan plan({}, 64);
  const std::optional<Pass> pass = plan.next(0, 1);
  REQUIRE(pass);
  CHECK(pass->first == 0);
  CHECK(pass->count == 64);
  CHECK_FALSE(plan.wants_error());
  CHECK_FALSE(plan.next(0.1, 1));
  CHECK(plan.ending() == Ending::samples);
}

TEST_CASE("with a deadline, a pass takes two fifths of the time that is left") {
  RenderGoal goal;
  goal.deadline = Clock::now();
  PassPlan plan(goal, 100000);
  CHECK(plan.next(0, 10)->count == 1);  // Nothing is known yet.
  CHECK(plan.next(0.1, 10)->count == 40);
  CHECK(plan.next(0.001, 0.1)->count == 40);
  CHECK(plan.next(0.1, 0.4)->count == 1);  // Single ones may end part-way.
  CHECK(plan.next(0.1, 0.01)->count == 1);
  CHECK(plan.next(0.001, 10)->first == 83);
  CHECK_FALSE(plan.next(0.001, 0));
  CHECK(plan.ending() == Ending::deadline);
}

TEST_CASE("an error that is no number is no answer") {
  RenderGoal goal;
  goal.max_error = 0.1;
  PassPlan plan(goal, 1000);
  int done = 0;
  while (const std::optional<Pass> pass = plan.next(0.1, 1)) {
    REQUIRE(pass->count > 0);
    done += pass->count;
    plan.estimated(error_of(std::numeric_limits<double>::quiet_NaN()));
  }
  CHECK(done == 1000);
}

TEST_CASE("an error is looked at where it may be reached") {
  RenderGoal goal;
  goal.max_error = 0.1;
  PassPlan plan(goal, 100000);
  CHECK(plan.next(0, 1)->count == 8);
  REQUIRE(plan.wants_error());
  plan.estimated(error_of(0.3));  // Nine times as many, but by no more than four at a time.
  CHECK(plan.next(0, 1)->count == 24);
  REQUIRE(plan.wants_error());
  plan.estimated(error_of(0.12));
  const int count = plan.next(0, 1)->count;
  CHECK(count >= 4);
  CHECK(count <= 16);
  plan.estimated(error_of(0.099));
  CHECK_FALSE(plan.next(0, 1));
  CHECK(plan.ending() == Ending::error);
}

TEST_CASE("where no error can be told, time or a number of samples ends it, else the next look does") {
  RenderGoal goal;
  goal.max_error = 0.1;
  PassPlan open(goal, 100000);
  CHECK(open.next(0, 1)->count == 8);
  REQUIRE(open.wants_error());
  open.cannot_estimate();
  CHECK_FALSE(open.is_for_error());
  CHECK_FALSE(open.next(0, 1));
  CHECK(open.ending() == Ending::unknown_error);

  goal.spp = 100;
  PassPlan counted(goal, 100);
  CHECK(counted.next(0, 1)->count == 8);
  counted.cannot_estimate();
  CHECK(counted.next(0, 1)->count == 92);
  CHECK_FALSE(counted.wants_error());
  CHECK_FALSE(counted.next(0, 1));
  CHECK(counted.ending() == Ending::samples);
}

TEST_CASE("the look of an earlier plan is for its own error; another one is looked at at once") {
  RenderGoal goal;
  goal.max_error = 0.1;
  PassPlan plan(goal, 1000);
  REQUIRE(plan.next(0, 1));
  plan.estimated(error_of(0.3));
  const PassPosition position = plan.position();
  CHECK(position.max_error == 0.1);
  const PassPosition under_way{20, position.check_at, position.max_error};
  const auto resumed = [&](std::optional<double> max_error, const PassPosition& from) {
    RenderGoal other;
    other.max_error = max_error;
    PassPlan next(other, 1000);
    next.go_on_from(from);
    return next;
  };
  CHECK_FALSE(resumed(0.1, under_way).wants_error());
  CHECK(resumed(0.1, under_way).next(0, 1)->count == position.check_at - 20);
  CHECK(resumed(0.2, under_way).wants_error());
  CHECK(resumed(0.2, {20, 900, std::nullopt}).wants_error());
  CHECK_FALSE(resumed(std::nullopt, under_way).wants_error());
  // Not before a plan of its own would.
  CHECK(resumed(0.2, {5, 32, 0.1}).next(0, 1)->count == 3);
}

TEST_CASE("few pixels do not end it by luck") {
  RenderGoal goal;
  goal.max_error = 0.1;
  PassPlan plan(goal, 1000);
  REQUIRE(plan.next(0, 1));
  plan.estimated(ErrorEstimate{0.09, 0.04, 0.14, 0});
  CHECK(plan.next(0, 1));
  plan.estimated(std::nullopt);
  CHECK(plan.next(0, 1));
}

}  // namespace
}  // namespace strahl
