// SPDX-License-Identifier: MIT
// The one table of promises; docs/selftest.md repeats it in words.
#include "selftest/promise.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <vector>

namespace strahl::selftest {
namespace {

using oracle::Law;

struct Row {
  const char* kind;
  double robust_ulps;
  double double_ulps;
  std::vector<Law> stable;  ///< Laws well-conditioned enough for its forms: none wrong.
  double stable_ulps;
};

constexpr double any = std::numeric_limits<double>::infinity();

const Row& row_of(const std::string& kind) {
  static const std::vector<Law> all{Law::aimed,      Law::log_uniform,   Law::border, Law::exact_border,
                                    Law::in_surface, Law::axis_parallel, Law::offset, Law::unnormalised};
  static const std::array rows{
      Row{"sphere", 1, 1, {Law::aimed, Law::offset, Law::unnormalised}, any},
      Row{"plane", 1, 1, {}, any},
      Row{"box", 2, 1, {Law::exact_border}, 2},
      Row{"triangle", 4, 1, all, any},
      Row{"parallelogram", 4, 1, all, any},
      Row{"disk", 1, 1, {}, any},
      Row{"cylinder", 8, 1, {}, any},
  };
  const auto* found = std::find_if(rows.begin(), rows.end(), [&](const Row& row) { return kind == row.kind; });
  if (found == rows.end()) throw std::logic_error("nothing is promised of shapes of kind " + kind);
  return *found;
}

}  // namespace

Promise promise_of(Precision precision, const std::string& kind, Law law) {
  const Row& row = row_of(kind);
  const bool leaves_range = law == Law::extreme;
  switch (precision) {
    case Precision::fast:
      return {};
    case Precision::stable:
      if (std::find(row.stable.begin(), row.stable.end(), law) == row.stable.end()) return {};
      return {true, row.stable_ulps};
    case Precision::robust:
      return leaves_range ? Promise{} : Promise{true, row.robust_ulps};
    case Precision::fp64:
      return {true, row.double_ulps};
  }
  throw std::logic_error("a precision without promises");
}

Promise promise_of_catalogue(Precision precision, const std::string& kind) {
  if (precision == Precision::fast || precision == Precision::stable) return {};
  return {true, precision == Precision::robust ? row_of(kind).robust_ulps : row_of(kind).double_ulps};
}

Promise promise_of_respawn(Precision precision, const std::string& kind) {
  if (precision == Precision::fast) return {};
  return {true, precision == Precision::robust ? row_of(kind).robust_ulps : any};
}

bool promises_closed_seams(Precision precision) { return precision != Precision::fast; }

}  // namespace strahl::selftest
