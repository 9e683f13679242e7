// SPDX-License-Identifier: MIT
// What tests and `strahl selftest` ask of a device: a ray against primitives of one kind, and the exact answer.
#pragma once

#include <string>
#include <vector>

#include "oracle/oracle.h"

namespace strahl::selftest {

enum class Expected {
  miss,
  hit,
  either,  ///< Both are right (within a declared band, or a case that the promise leaves open); NaN never is.
};

/// Every number is a float, so that tiers of 32 and 64 bits see the same input.
struct Question {
  std::string kind;            ///< Entry of cl/shapes/shapes.def: "sphere", "triangle", ...
  std::vector<double> planes;  ///< Primitive after primitive, the block planes that cl/shapes/<kind>.h states.
  oracle::Ray ray;
  int left = -1;  ///< Index of the primitive that the ray has just left, -1: none.

  Expected expected = Expected::either;
  int primitive = -1;  ///< Index of the one that is hit, where hit; -1: any will do.
  oracle::Exact t;     ///< Where hit.
  /// No ulps are promised for |t| at or below this: origins that are on the surface to rounding see t = 0.
  double t_rounding = 0;
};

/// How an answer compares.
struct Judgement {
  bool is_wrong = false;  ///< Hit for miss, miss for hit, another primitive, or NaN.
  bool is_nan = false;
  double ulps = 0;  ///< Of t, in ulps of float; 0 where nothing is promised of it.
};

/// t: as the device gave it, infinite for a miss; primitive: index of what was hit, -1 for a miss.
[[nodiscard]] Judgement judge(const Question&, double t, int primitive);

}  // namespace strahl::selftest
