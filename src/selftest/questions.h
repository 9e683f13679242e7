// SPDX-License-Identifier: MIT
// Questions drawn from the oracle's generators, for every kind of shape by every law: the planes that a device would
// hold of a case, the exact answer for those planes, and the band within which nothing is promised.
#pragma once

#include <string>

#include "oracle/generators.h"
#include "selftest/question.h"
#include "selftest/to_float.h"

namespace strahl::selftest {

/// Appends the components, rounded to float.
void put(std::vector<double>& planes, const Vec3& v);

/// One primitive of the kind (cl/shapes/shapes.def) and a ray towards it. Expected::either within the bands that
/// its proof states (selftest/shapes/), and where rounding t moves it across the ends of the ray's range. Throws
/// std::logic_error for an unknown kind.
[[nodiscard]] Question draw_question(const std::string& kind, oracle::Law, oracle::Random&);

/// Takes an answer of the oracle: decided outside the band, and where no crossing is so close to t_min or t_max that
/// rounding t moves it across.
void settle(Question&, const oracle::Answer&, bool is_outside_band);

}  // namespace strahl::selftest
