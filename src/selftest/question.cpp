// SPDX-License-Identifier: MIT
#include "selftest/question.h"

#include <cmath>

namespace strahl::selftest {

Judgement judge(const Question& question, double t, int primitive) {
  Judgement judgement;
  judgement.is_nan = std::isnan(t);
  const bool is_hit = std::isfinite(t);
  // Of several at the same t any will do, but one there must be.
  const bool is_other = is_hit && (question.primitive >= 0 ? primitive != question.primitive : primitive < 0);
  switch (question.expected) {
    case Expected::miss:
      judgement.is_wrong = is_hit;
      break;
    case Expected::hit:
      judgement.is_wrong = !is_hit || is_other;
      break;
    case Expected::either:
      break;
  }
  if (judgement.is_nan) judgement.is_wrong = true;
  if (question.expected != Expected::hit || judgement.is_wrong) return judgement;
  if (std::fabs((t - question.t.value) - question.t.rest) <= question.t_rounding) return judgement;
  judgement.ulps = oracle::ulp_error_f32(t, question.t);
  return judgement;
}

}  // namespace strahl::selftest
