// SPDX-License-Identifier: MIT
// What a tier of precision promises of the questions that a law draws (selftest/questions.h, whose bands are left out):
// each shape's own promises (selftest/shape_proof.h), by tier.
#pragma once

#include <limits>
#include <string>

#include "oracle/generators.h"
#include "settings/settings.h"

namespace strahl::selftest {

struct Promise {
  bool none_wrong = false;
  double ulps = std::numeric_limits<double>::infinity();  ///< Of float, of t.
};

[[nodiscard]] Promise promise_of(Precision precision, const std::string& kind, oracle::Law law);

[[nodiscard]] Promise promise_of_catalogue(Precision precision, const std::string& kind);

/// Of a ray that leaves what it has hit, and of closed meshes at their seams.
[[nodiscard]] Promise promise_of_respawn(Precision precision, const std::string& kind);
[[nodiscard]] bool promises_closed_seams(Precision precision);

}  // namespace strahl::selftest
