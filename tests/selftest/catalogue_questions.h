// SPDX-License-Identifier: MIT
// What the tests of the catalogue share: every question with its row, and what is wrong with an answer.
#pragma once

#include <sstream>
#include <string>
#include <vector>

#include "selftest/catalogue.h"

namespace strahl::test {

struct AskedByRow {
  const selftest::Row* row;
  int number;  ///< Within the row.
  selftest::Question question;
};

inline std::vector<AskedByRow> all_questions() {
  std::vector<AskedByRow> all;
  for (const selftest::Row& row : selftest::catalogue()) {
    int number = 0;
    for (selftest::Question& q : selftest::questions_of(row)) all.push_back({&row, number++, std::move(q)});
  }
  return all;
}

/// Bounds of t in the robust tier, in ulps of float: docs/decisions/0007-robust-tier.md.
inline double robust_bound(const std::string& kind) {
  if (kind == "cylinder") return 8;
  if (kind == "triangle" || kind == "parallelogram") return 4;
  return kind == "box" ? 2 : 1;
}

/// In the double tier, in ulps of float.
inline double double_bound(const std::string&) { return 1; }

/// "" where the answer is right, no NaN, and within the bound.
inline std::string fault(const AskedByRow& asked, double t, int primitive, double bound) {
  const selftest::Question& q = asked.question;
  const selftest::Judgement judgement = selftest::judge(q, t, primitive);
  if (!judgement.is_wrong && judgement.ulps <= bound) return {};
  std::ostringstream text;
  text.precision(9);
  text << "[" << asked.row->id << "] " << asked.row->title << ", question " << asked.number << ": a " << q.kind
       << " answers t " << t << " of " << primitive << ", expected is ";
  if (q.expected == selftest::Expected::hit)
    text << "t " << q.t.value << " of " << q.primitive << "; " << judgement.ulps << " ulp";
  else
    text << (q.expected == selftest::Expected::miss ? "a miss" : "anything but NaN");
  return text.str();
}

}  // namespace strahl::test
