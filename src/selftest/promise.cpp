// SPDX-License-Identifier: MIT
#include "selftest/promise.h"

#include <algorithm>
#include <stdexcept>

#include "selftest/shape_proof.h"

namespace strahl::selftest {

using oracle::Law;

Promise promise_of(Precision precision, const std::string& kind, Law law) {
  const Promises promises = proof_of(kind).promises();
  const bool leaves_range = law == Law::extreme;
  switch (precision) {
    case Precision::fast:
      return {};
    case Precision::stable:
      if (std::find(promises.stable.begin(), promises.stable.end(), law) == promises.stable.end()) return {};
      return {true, promises.stable_ulps};
    case Precision::robust:
      return leaves_range ? Promise{} : Promise{true, promises.robust_ulps};
    case Precision::fp64:
      return {true, promises.double_ulps};
  }
  throw std::logic_error("a precision without promises");
}

Promise promise_of_catalogue(Precision precision, const std::string& kind) {
  if (precision == Precision::fast || precision == Precision::stable) return {};
  return {true, precision == Precision::robust ? proof_of(kind).promises().robust_ulps
                                               : proof_of(kind).promises().double_ulps};
}

Promise promise_of_respawn(Precision precision, const std::string& kind) {
  if (precision == Precision::fast) return {};
  return {true, precision == Precision::robust ? proof_of(kind).promises().robust_ulps
                                               : std::numeric_limits<double>::infinity()};
}

bool promises_closed_seams(Precision precision) { return precision != Precision::fast; }

}  // namespace strahl::selftest
