// SPDX-License-Identifier: MIT
// Rows dealt to devices: every row once, shares by speed, nobody waits in vain, what failed is done by others.
#include <algorithm>
#include <catch2/catch.hpp>
#include <limits>
#include <numeric>

#include "render/row_deal.h"

namespace strahl {
namespace {

struct Simulated {
  std::vector<int> times;       ///< Each row was rendered.
  std::vector<int> rows_of;     ///< By each worker.
  std::vector<double> ends_at;  ///< When each was done with its last rows.
};

/// Workers that need 1 / speed seconds a row. fails_at: when the first of them fails.
Simulated simulate(int rows, const std::vector<double>& speeds, bool is_known,
                   double fails_at = std::numeric_limits<double>::infinity()) {
  std::vector<RowDeal::Worker> workers(speeds.size());
  for (std::size_t i = 0; i < speeds.size(); ++i) workers[i].speed = is_known ? speeds[i] : 0;
  RowDeal deal({0, rows}, workers);
  Simulated result{std::vector<int>(static_cast<std::size_t>(rows)), std::vector<int>(speeds.size()),
                   std::vector<double>(speeds.size())};
  struct Busy {
    double until;
    Rows rows;
  };
  std::vector<std::optional<Busy>> busy(speeds.size());
  double now = 0;
  bool has_failed = false;
  for (int turns = 0; !deal.is_finished(); ++turns) {
    REQUIRE(turns < 100000);
    for (std::size_t i = 0; i < speeds.size(); ++i)
      if (!busy[i] && !deal.worker(i).is_out)
        if (const auto got = deal.next(i)) busy[i] = Busy{now + got->count / speeds[i], *got};
    std::size_t first = speeds.size();
    for (std::size_t i = 0; i < speeds.size(); ++i)
      if (busy[i] && (first == speeds.size() || busy[i]->until < busy[first]->until)) first = i;
    REQUIRE(first < speeds.size());  // Else all wait for each other.
    if (!has_failed && busy[0] && busy[first]->until > fails_at) {
      has_failed = true;
      now = std::max(now, fails_at);
      deal.failed(0);
      busy[0].reset();
      continue;
    }
    now = busy[first]->until;
    const Rows done = busy[first]->rows;
    for (int y = done.first; y < done.first + done.count; ++y) ++result.times.at(static_cast<std::size_t>(y));
    result.rows_of[first] += done.count;
    result.ends_at[first] = now;
    deal.done(first, done.count / speeds[first]);
    busy[first].reset();
  }
  return result;
}

bool is_each_once(const std::vector<int>& times) {
  return std::all_of(times.begin(), times.end(), [](int n) { return n == 1; });
}

TEST_CASE("each row once, whatever the speeds") {
  for (const bool is_known : {false, true})
    for (const int rows : {1, 2, 7, 480})
      for (const auto& speeds : std::vector<std::vector<double>>{
               {1}, {1, 1}, {1, 1, 1}, {100, 1}, {1, 100}, {1e-3, 1e4, 3}, {5, 5, 5, 5, 1}})
        CHECK(is_each_once(simulate(rows, speeds, is_known).times));
}

TEST_CASE("shares are as the speeds, and all end together") {
  for (const bool is_known : {false, true}) {
    const Simulated result = simulate(1000, {100, 300}, is_known);
    CHECK(result.rows_of[0] == Approx(250).margin(10));
    CHECK(result.ends_at[0] == Approx(2.5).margin(0.05));
    CHECK(result.ends_at[1] == Approx(2.5).margin(0.05));
  }
}

TEST_CASE("a slow device does not hold up the last rows") {
  const Simulated result = simulate(100, {100, 0.5}, true);
  CHECK(*std::max_element(result.ends_at.begin(), result.ends_at.end()) < 1.02);
  CHECK(result.rows_of[1] == 0);
  // Nor the first ones, while nobody knows that it is slow: 1,080 rows take the fast one alone 1.08 s.
  for (const auto& speeds : std::vector<std::vector<double>>{{1000, 1}, {1, 1000}}) {
    const Simulated unknown = simulate(1080, speeds, false);
    CHECK(*std::max_element(unknown.ends_at.begin(), unknown.ends_at.end()) < 1.1);
  }
}

TEST_CASE("rows of a device that fails are done by the others") {
  for (const double fails_at : {0.0, 0.001, 0.3, 0.5, 0.9}) {
    INFO("fails at " << fails_at);
    const Simulated result = simulate(200, {100, 100, 1}, true, fails_at);
    CHECK(is_each_once(result.times));
    CHECK(result.rows_of[0] < 100);
  }
}

TEST_CASE("a device that was held up once is asked again") {
  RowDeal deal({0, 1000}, {{100, false, {}}, {100, false, {}}});
  REQUIRE(deal.next(0));
  const double rows = deal.worker(0).rows.count;
  deal.done(0, 1000 * rows / 100);  // A thousandth of its speed.
  CHECK(deal.worker(0).speed == 25);
  REQUIRE(deal.next(0));
  const double more = deal.worker(0).rows.count;
  deal.done(0, more / 80);
  CHECK(deal.worker(0).speed == Approx(80));
}

TEST_CASE("rows that are cut short are not rendered, and tell a speed by what was made of them") {
  RowDeal deal({0, 1}, {{100, false, {}}});
  REQUIRE(deal.next(0)->count == 1);
  deal.stopped(0, 0.5, 0.5 / 80);
  CHECK(deal.worker(0).speed == Approx(80));
  CHECK_FALSE(deal.is_finished());
  deal.stopped(0, 0, 10);
  CHECK(deal.worker(0).speed == Approx(80));
}

TEST_CASE("at most a second's rows at a time") {
  RowDeal deal({0, 100000}, {{10, false, {}}, {20, false, {}}});
  CHECK(deal.next(0)->count == 10);
  CHECK(deal.next(1)->count == 20);
}

}  // namespace
}  // namespace strahl
