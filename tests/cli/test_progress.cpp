// SPDX-License-Identifier: MIT
// What is said of work under way: no estimate before there is one, a log that is not silent, a word for compilers.
#include <catch2/catch.hpp>
#include <chrono>
#include <future>

#include "cli/progress_bar.h"
#include "opencl/compiling.h"

namespace strahl::cli {
namespace {

/// Launches begin small: the first half a second shows a thousandth of the rate that holds later.
TEST_CASE("no estimate before the rate holds") {
  RemainingTime time;
  for (double t = 0.02; t < 0.5; t += 0.02) {
    time.add(t, 2e-4 * t);
    CHECK_FALSE(time.left());
  }
  bool is_estimated = false;
  for (double t = 0.5; t < 8; t += 0.05) {
    time.add(t, 0.1 * t - 0.05);
    if (!time.left()) continue;
    is_estimated = true;
    CHECK(*time.left() == Approx(10.5 - t).epsilon(0.1));
  }
  CHECK(is_estimated);
}

TEST_CASE("an estimate goes where the total does") {
  RemainingTime time;
  for (int i = 1; i <= 40; ++i) time.add(0.1 * i, 0.02 * i);
  CHECK(*time.left() == Approx(1.0));
  time.add(4.1, 0.2);  // Four times as many samples, as the first look at the error says.
  CHECK_FALSE(time.left());
  RemainingTime still;
  for (int i = 1; i <= 40; ++i) still.add(0.1 * i, 0.5);
  CHECK_FALSE(still.left());
}

TEST_CASE("a long run keeps its estimate") {
  RemainingTime time;
  for (int i = 1; i <= 100000; ++i) time.add(0.05 * i, 5e-6 * i);
  CHECK(*time.left() == Approx(5000).epsilon(0.01));
}

TEST_CASE("a log gets a line after 10 s, and then each time that twice as much has gone by") {
  ReportSchedule schedule;
  std::vector<int> due;
  for (int second = 0; second <= 100; ++second)
    if (schedule.is_due(second)) due.push_back(second);
  CHECK(due == std::vector<int>{10, 20, 40, 80});
  CHECK(schedule.is_due(1000));
  CHECK_FALSE(schedule.is_due(1279));
}

TEST_CASE("in words and as a bar") {
  ProgressView view{"render", "", 20, 0.5, 19.6, 1.5e6, false};
  CHECK(progress_report(view) == "strahl: render 50 % · 20 s so far · about 20 s left");
  CHECK(progress_line(view) == "render  50 % [===============               ] 1.50 Msamples/s 20 s left");
  view.left.reset();
  view.share.reset();
  CHECK(progress_line(view) == "render 1.50 Msamples/s");
  CHECK(progress_report(view) == "strahl: render · 20 s so far");
  view.compiling = true;
  CHECK(progress_line(view) == "render · compiling, 20 s so far");
  CHECK(progress_report(view) == "strahl: render · compiling · 20 s so far");
}

/// What a screen hears first that has `part` in it; the wait has an end only where the test fails.
template <class Show>
bool hears(const std::string& part, Show screen_for) {
  std::promise<void> heard;
  bool done = false;
  const auto listen = [&](const std::string& text) {
    if (!done && text.find(part) != std::string::npos) {
      done = true;
      heard.set_value();
    }
  };
  const Compiling compiling;
  const ProgressBar bar("work", screen_for(listen));
  return heard.get_future().wait_for(std::chrono::minutes(1)) == std::future_status::ready;
}

TEST_CASE("a compiler is named while it works, on a terminal and in a log") {
  CHECK(hears("compiling", [](const auto& listen) { return ProgressScreen{listen, nullptr}; }));
  CHECK(hears("compiling", [](const auto& listen) { return ProgressScreen{nullptr, listen}; }));
}

}  // namespace
}  // namespace strahl::cli
