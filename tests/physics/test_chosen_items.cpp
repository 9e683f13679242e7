// SPDX-License-Identifier: MIT
// Kernels find the item that a table leads to, whatever its weights are, and wherever it stands among others.
#include <random>

#include "packing/choice_table.h"
#include "physics/transport_scenes.h"

using namespace strahl;
using namespace strahl::test;

namespace {

std::vector<double> weights_of(std::size_t items, int sort, std::mt19937& random) {
  std::vector<double> weights(items);
  for (double& weight : weights) {
    weight = sort == 0 ? 1 : std::exp(-20.0 * static_cast<double>(random()) / 0x1p32);
    if (sort == 2 && random() % 2 == 0) weight = 0;
  }
  // As a sun in a dark sky: nearly all numbers lead to it, and nearly all items share a part.
  if (sort == 3) weights[random() % items] = 1e9;
  weights[random() % items] += 1e-3;
  return weights;
}

/// Around each item's last number, and elsewhere.
std::vector<std::uint32_t> numbers_of(const std::vector<Choice>& table, std::mt19937& random) {
  std::vector<std::uint32_t> numbers{0, 0xffffffffU};
  for (const Choice& choice : table)
    for (const std::uint32_t number : {choice.last - 1, choice.last, choice.last + 1}) numbers.push_back(number);
  for (int i = 0; i < 100; ++i) numbers.push_back(static_cast<std::uint32_t>(random()));
  return numbers;
}

}  // namespace

TEST_CASE("the item that numbers choose") {
  std::mt19937 random(3);
  for (const std::size_t items : {1, 2, 3, 4, 5, 17, 1000})
    for (const int sort : {0, 1, 2, 3}) {
      // Two tables behind each other, of which the second is asked.
      const std::vector<Choice> other = choice_table(weights_of(7, 1, random));
      const std::vector<double> weights = weights_of(items, sort, random);
      const std::vector<Choice> table = choice_table(weights);
      std::vector<std::int32_t> words;
      for (const auto* one : {&other, &table})
        for (const Choice& choice : *one) {
          words.push_back(static_cast<std::int32_t>(choice.last));
          words.push_back(choice.guide);
        }
      const std::vector<std::uint32_t> numbers = numbers_of(table, random);
      for (const TransportTier& tier : transport_tiers()) {
        INFO(tier.name << ", " << tier.lanes << " lanes, " << items << " items, weights of sort " << sort);
        const std::vector<int> chosen = tier.choose(words, 7, static_cast<unsigned>(items), numbers);
        std::size_t wrong = 0;
        for (std::size_t i = 0; i < numbers.size(); ++i) {
          std::size_t item = 0;
          while (table[item].last < numbers[i] || !(weights[item] > 0)) ++item;
          wrong += chosen[i] != static_cast<int>(item);
        }
        CHECK(wrong == 0);
      }
    }
}
