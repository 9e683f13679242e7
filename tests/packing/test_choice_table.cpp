// SPDX-License-Identifier: MIT
// Items are drawn in proportion to their weights, in order, from the table that packing/choice_table.h makes.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <random>
#include <vector>

#include "packing/choice_table.h"

using namespace strahl;

namespace {

constexpr std::uint64_t all_numbers = std::uint64_t{1} << 32;

/// The item of a number, from its part's guide on.
std::size_t item_of(const std::vector<Choice>& table, std::uint32_t number) {
  auto item = static_cast<std::size_t>(table[number * table.size() >> 32].guide);
  while (table.at(item).last < number) ++item;
  return item;
}

/// Each item's first number and the one beyond its last, from `last` alone.
std::vector<std::array<std::uint64_t, 2>> ranges_of(const std::vector<Choice>& table,
                                                    const std::vector<double>& weights) {
  std::vector<std::array<std::uint64_t, 2>> ranges(table.size());
  std::uint64_t begin = 0;
  for (std::size_t i = 0; i < table.size(); ++i) {
    const std::uint64_t end = weights[i] > 0 ? std::uint64_t{table[i].last} + 1 : begin;
    ranges[i] = {begin, end};
    begin = end;
  }
  return ranges;
}

void check(const std::vector<double>& weights) {
  const std::vector<Choice> table = choice_table(weights);
  REQUIRE(table.size() == weights.size());
  const auto ranges = ranges_of(table, weights);
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  std::size_t wrong = 0;
  double share = 0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const auto [begin, end] = ranges[i];
    share += weights[i] / sum;
    if (!(weights[i] > 0)) continue;
    wrong += end <= begin;
    // An item below a number's worth takes one from its neighbours.
    wrong += std::abs(static_cast<double>(end) - std::ldexp(share, 32)) > static_cast<double>(weights.size());
    wrong += item_of(table, static_cast<std::uint32_t>(begin)) != i;
    wrong += item_of(table, static_cast<std::uint32_t>(end - 1)) != i;
    wrong += item_of(table, static_cast<std::uint32_t>(begin + (end - begin) / 2)) != i;
  }
  CHECK(wrong == 0);
  CHECK(ranges.back()[1] == all_numbers);
}

}  // namespace

TEST_CASE("choices in proportion to weights, in order") {
  check({1});
  check({1, 1, 1, 1});
  check({2, 6});
  check({0, 0, 1, 0, 3, 0});
  check({1e-300, 1, 1e-300});
  check({1e300, 1e-5, 1e-5});
  check(std::vector<double>(1000, 0.1));
  std::mt19937_64 engine(5);
  std::exponential_distribution<double> exponent(0.1);
  for (const std::size_t items : {2, 7, 64, 4097}) {
    std::vector<double> weights(items);
    for (double& weight : weights) weight = engine() % 5 == 0 ? 0 : std::exp(-exponent(engine));
    weights[engine() % items] = 1;
    check(weights);
  }
}

TEST_CASE("equal shares are those of a number's leading part") {
  const std::vector<Choice> table = choice_table(std::vector<double>(3, 1.0));
  std::mt19937 engine(6);
  for (int i = 0; i < 1000; ++i) {
    const auto number = static_cast<std::uint32_t>(engine());
    CHECK(item_of(table, number) == std::uint64_t{number} * 3 >> 32);
  }
}
