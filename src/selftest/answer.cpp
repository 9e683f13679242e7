// SPDX-License-Identifier: MIT
// Of several primitives; of one: selftest/shapes/.
#include "selftest/answer.h"

#include <algorithm>
#include <cmath>

#include "packing/pack_shapes.h"
#include "selftest/shape_proof.h"
#include "selftest/to_float.h"

namespace strahl::selftest {
namespace {

bool is_usable(const oracle::Ray& ray) {
  const Vec3 &o = ray.origin, &d = ray.direction;
  if (std::isnan(ray.t_min) || std::isnan(ray.t_max)) return false;
  for (const double x : {o.x, o.y, o.z, d.x, d.y, d.z})
    if (!std::isfinite(x)) return false;
  return d != Vec3{};
}

bool is_before(const oracle::Exact& a, const oracle::Exact& b) {
  return a.value < b.value || (a.value == b.value && a.rest < b.rest);
}

/// So close that two correct answers may come out in either order.
bool is_close(const oracle::Exact& a, const oracle::Exact& b) {
  return std::fabs(a.value - b.value) <= 8 * u * std::fmax(std::fabs(a.value), std::fabs(b.value));
}

}  // namespace

ExactAnswer exact_answer(const Question& q) {
  const ShapeProof& proof = proof_of(q.kind);
  const int planes = planes_of(q.kind);
  ExactAnswer nearest;
  if (!is_usable(q.ray)) return nearest;
  bool are_all_promised = true;
  std::vector<oracle::Exact> met;
  const int count = static_cast<int>(q.planes.size()) / planes;
  for (int i = 0; i < count; ++i) {
    ExactAnswer one = proof.answer({q.ray, q.planes.data() + i * planes, i == q.left});
    are_all_promised = are_all_promised && one.is_promised;
    if (one.hit) met.push_back(one.t);
    if (!one.hit || (nearest.hit && !is_before(one.t, nearest.t))) continue;
    nearest = one;
    nearest.primitive = i;
  }
  nearest.is_promised = are_all_promised;
  const auto rival = [&](const oracle::Exact& t) { return is_close(t, nearest.t); };
  nearest.is_alone = std::count_if(met.begin(), met.end(), rival) <= 1;
  return nearest;
}

void answer(Question& q) {
  const ExactAnswer exact = exact_answer(q);
  q.expected = !exact.is_promised ? Expected::either : exact.hit ? Expected::hit : Expected::miss;
  q.primitive = exact.hit && exact.is_alone ? exact.primitive : -1;
  q.t = exact.t;
  q.t_rounding = exact.t_rounding;
}

}  // namespace strahl::selftest
