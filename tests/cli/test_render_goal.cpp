// SPDX-License-Identifier: MIT
// Whether a goal was reached, whatever ended the render.
#include <catch2/catch.hpp>

#include "cli/render_goal.h"
#include "errors.h"

namespace strahl::cli {
namespace {

RenderOptions until(double error) {
  RenderOptions options;
  options.goal.max_error = error;
  options.goal.time = "10s";
  return options;
}

RenderResult ended_by(Ending ending, double rmse) {
  RenderResult result;
  result.color.width = result.color.height = 8;
  result.ending = ending;
  result.stats.spp = result.stats.least_spp = result.stats.most_spp = 12;
  result.stats.seconds.total = 10;
  result.stats.error = ErrorBudget{{rmse, 0.9 * rmse, 1.05 * rmse, 0.1}, 0, 0, std::nullopt};
  return result;
}

TEST_CASE("the picture's own error counts, not what ended it") {
  for (const Ending ending : {Ending::samples, Ending::deadline, Ending::error}) {
    INFO(ending_name(ending));
    CHECK_FALSE(missed_goal(until(0.1), ended_by(ending, 0.09)));
    const std::optional<std::string> missed = missed_goal(until(0.1), ended_by(ending, 0.2));
    REQUIRE(missed);
    CHECK(missed->find("--max-error 0.1: 0.2") == 0);
  }
  // As where the render looks on its way: the interval's upper end counts too.
  RenderResult lucky = ended_by(Ending::deadline, 0.09);
  lucky.stats.error->noise.rmse_high = 0.2;
  CHECK(missed_goal(until(0.1), lucky));
}

TEST_CASE("a deadline leaves no time for what is traced after the last sample") {
  RenderOptions options;
  options.kernel.aovs = {"depth", "numeric_error"};
  CHECK_NOTHROW(check_goal(options));
  options.goal.max_error = 0.1;
  CHECK_NOTHROW(check_goal(options));
  options.goal.time = "10s";
  CHECK_THROWS_AS(check_goal(options), UsageError);
  options.kernel.aovs = {"depth"};
  CHECK_NOTHROW(check_goal(options));
}

TEST_CASE("an error that is not told is not reached, and the message says why") {
  RenderResult result = ended_by(Ending::error, 0.01);
  result.stats.error.reset();
  result.stats.unusual.invalid = 1;
  CHECK(missed_goal(until(0.1), result).value_or("").find("samples were not finite") != std::string::npos);
  result.stats.unusual.invalid = 0;
  CHECK(missed_goal(until(0.1), result).value_or("").find("fewer than 4 samples") != std::string::npos);
}

}  // namespace
}  // namespace strahl::cli
