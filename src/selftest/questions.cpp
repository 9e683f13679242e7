// SPDX-License-Identifier: MIT
#include "selftest/questions.h"

#include "selftest/answer.h"
#include "selftest/shape_proof.h"

namespace strahl::selftest {

void put(std::vector<double>& planes, const Vec3& v) {
  for (const double x : {v.x, v.y, v.z}) planes.push_back(to_float(x));
}

void settle(Question& q, const oracle::Answer& answer, bool is_outside_band) {
  const bool is_decided = is_outside_band && answer.range_margin >= 4 * u;
  q.expected = !is_decided ? Expected::either : answer.hit ? Expected::hit : Expected::miss;
  q.primitive = answer.hit ? 0 : -1;
  q.t = answer.t;
}

Question draw_question(const std::string& kind, oracle::Law law, oracle::Random& random) {
  Question q;
  q.kind = kind;
  proof_of(kind).draw(q, random, law);
  answer(q);
  return q;
}

}  // namespace strahl::selftest
