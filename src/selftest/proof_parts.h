// SPDX-License-Identifier: MIT
// What the proofs of several shapes are made of.
#pragma once

#include <cmath>

#include "oracle/number.h"
#include "selftest/shape_proof.h"
#include "selftest/to_float.h"

namespace strahl::selftest {

using Long = oracle::Vector<long double>;

inline Vec3 at(const double* planes) { return {planes[0], planes[1], planes[2]}; }

/// Products of three lengths must stay within float.
inline bool is_in_scale(double length) { return length >= 0x1p-40 && length <= 0x1p40; }

/// Size of what the ray sees, in units of t.
inline double reach(const oracle::Ray& ray, const Vec3& point, double size) {
  return (length(ray.origin - point) + size) / length(ray.direction);
}

/// Promised outside the shape's band, where no crossing is so close to the ends of the ray's range that rounding t
/// moves it across.
inline ExactAnswer outside_band(const oracle::Answer& answer, bool is_outside) {
  return {answer.hit, 0, true, answer.t, is_outside && answer.range_margin >= 4 * u};
}

/// The root of a quadric that was left: hit where t > 0 and in range.
inline ExactAnswer other_root(const oracle::Ray& ray, const mpq_class& t) {
  ExactAnswer answer;
  answer.hit = sgn(t) > 0 && oracle::in_range(ray, t);
  answer.t = oracle::to_exact(t);
  return answer;
}

/// Expects the other root of a quadric that was left, known in long double.
inline void expect_root(Question& q, long double t) {
  q.expected = t > 0 ? Expected::hit : Expected::miss;
  q.primitive = t > 0 ? 0 : -1;
  q.t.value = static_cast<double>(t);
  q.t.rest = static_cast<double>(t - static_cast<long double>(q.t.value));
}

/// How much of |f| |d| may be lost of f . d: the stable forms round f and each product. long double keeps 2^-40 of it
/// and more where it cancels.
inline double lost_of_product(Precision precision) { return precision == Precision::robust ? 0x1p-40 : 0x1p-18; }

}  // namespace strahl::selftest
