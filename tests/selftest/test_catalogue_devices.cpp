// SPDX-License-Identifier: MIT
// Every question of the catalogue, put to PoCL in the robust and the double tier: no wrong answer, no NaN, t within the
// bounds. 6 s where no program is cached.
#include <catch2/catch.hpp>
#include <map>

#include "selftest/answer.h"
#include "selftest/catalogue_questions.h"
#include "selftest/probe.h"
#include "support/devices.h"

using namespace strahl;
using namespace strahl::selftest;
using namespace strahl::test;

namespace {

void hold(const Device& device, Precision precision, const std::vector<AskedByRow>& asked) {
  const bool is_double = precision == Precision::fp64;
  std::vector<Question> questions;
  for (const AskedByRow& one : asked) questions.push_back(one.question);
  Probe probe(device, questions.front().kind, precision);
  const std::vector<Answer> answers = probe.ask(questions);
  REQUIRE(answers.size() == asked.size());
  for (std::size_t i = 0; i < asked.size(); ++i) {
    const std::string& kind = questions[i].kind;
    const double bound = is_double ? double_bound(kind) : robust_bound(kind);
    const std::string wrong = fault(asked[i], answers[i].t, answers[i].primitive, bound);
    if (!wrong.empty()) FAIL_CHECK(precision_name(precision) << ": " << wrong);
  }
}

}  // namespace

TEST_CASE("PoCL answers every row in the robust and the double tier") {
  require_pocl();
  std::map<std::string, std::vector<AskedByRow>> by_kind;
  for (AskedByRow& asked : all_questions()) by_kind[asked.question.kind].push_back(std::move(asked));
  CHECK(by_kind.size() == 7);
  const Device single = Device::open("pocl"), wide = Device::open("pocl", {true});
  for (const auto& [kind, asked] : by_kind) {
    hold(single, Precision::robust, asked);
    hold(wide, Precision::fp64, asked);
  }
}
