// SPDX-License-Identifier: MIT
#include "selftest/tally.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace strahl::selftest {

void Tally::add(const Question& question, const Answer& answer) {
  const Judgement judgement = judge(question, answer.t, answer.primitive);
  ++cases;
  nans += judgement.is_nan;
  if (judgement.is_wrong) {
    if (wrong++ == 0) first_wrong = text_of(question, answer);
  } else if (question.expected == Expected::hit) {
    ulps_.push_back(static_cast<float>(judgement.ulps));
  }
}

void Tally::add(const Tally& other) {
  cases += other.cases;
  wrong += other.wrong;
  nans += other.nans;
  if (first_wrong.empty()) first_wrong = other.first_wrong;
  ulps_.insert(ulps_.end(), other.ulps_.begin(), other.ulps_.end());
}

double Tally::max_ulps() const {
  return ulps_.empty() ? 0 : static_cast<double>(*std::max_element(ulps_.begin(), ulps_.end()));
}

double Tally::p99_ulps() const {
  if (ulps_.empty()) return 0;
  std::vector<float> sorted = ulps_;
  const auto at = sorted.begin() + static_cast<std::ptrdiff_t>((sorted.size() - 1) * 99 / 100);
  std::nth_element(sorted.begin(), at, sorted.end());
  return static_cast<double>(*at);
}

std::string text_of(const Question& question, const Answer& answer) {
  const oracle::Ray& ray = question.ray;
  std::string text = fmt::format(
      "{} at {:a} {:a} {:a} towards {:a} {:a} {:a}, t in [{:a}, {:a}]{}: t {:a}, primitive {}", question.kind,
      ray.origin.x, ray.origin.y, ray.origin.z, ray.direction.x, ray.direction.y, ray.direction.z, ray.t_min, ray.t_max,
      question.left < 0 ? "" : fmt::format(", leaving {}", question.left), answer.t, answer.primitive);
  if (question.expected == Expected::hit)
    text += fmt::format(", not {:a} of {}", question.t.value, question.primitive);
  else if (question.expected == Expected::miss)
    text += ", not a miss";
  if (question.planes.size() > 12) return text + fmt::format("; {} planes", question.planes.size());
  text += "; planes";
  for (const double x : question.planes) text += fmt::format(" {:a}", x);
  return text;
}

}  // namespace strahl::selftest
