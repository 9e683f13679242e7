// SPDX-License-Identifier: MIT
// Answers added up: how many are wrong, how far off the others are.
#pragma once

#include <string>
#include <vector>

#include "selftest/probe.h"
#include "selftest/question.h"

namespace strahl::selftest {

class Tally {
 public:
  void add(const Question& question, const Answer& answer);

  std::size_t cases = 0;  ///< Whatever was expected.
  std::size_t wrong = 0;  ///< NaN included.
  std::size_t nans = 0;
  std::string first_wrong;  ///< Question and answer with every bit, empty where there is none.

  [[nodiscard]] double max_ulps() const;
  /// The error that one hit in a hundred exceeds.
  [[nodiscard]] double p99_ulps() const;
  void add(const Tally& other);

 private:
  std::vector<float> ulps_;  ///< Of every hit that was promised and found.
};

/// Question and answer on one line, numbers in hex.
[[nodiscard]] std::string text_of(const Question& question, const Answer& answer);

}  // namespace strahl::selftest
