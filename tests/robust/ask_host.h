// SPDX-License-Identifier: MIT
// Questions of the self test, answered by the robust tier on the host.
#pragma once

#include <array>

#include "robust/kernels.h"
#include "selftest/questions.h"

namespace strahl::test {

inline std::array<float, 8> reals_of(const oracle::Ray& ray) {
  std::array<float, 8> reals{};
  std::size_t i = 0;
  for (const double x : {ray.origin.x, ray.origin.y, ray.origin.z, ray.direction.x, ray.direction.y, ray.direction.z,
                         ray.t_min, ray.t_max})
    reals[i++] = static_cast<float>(selftest::to_float(x));
  return reals;
}

/// t, infinite for a miss; of a question about one primitive.
inline float ask_host(const selftest::Question& q, Route route = Route::double_words) {
  std::vector<float> planes;
  for (const double x : q.planes) planes.push_back(static_cast<float>(x));
  return robust_t(q.kind, planes, reals_of(q.ray), q.left == 0, route);
}

}  // namespace strahl::test
