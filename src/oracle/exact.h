// SPDX-License-Identifier: MIT
// A ray parameter known far beyond double precision, and the error of a computed one in units in the last place.
// ulp after Muller, "On the definition of ulp(x)", INRIA RR-5504, 2005, with the conventions of the OpenCL conformance
// tests: at a power of two the finer binade counts, an infinite result stands for the first number out of range.
#pragma once

namespace strahl::oracle {

/// t = value + rest, relative error below 2^-80 (2^-190 from the rational path).
struct Exact {
  double value = 0;  ///< the double nearest to t
  double rest = 0;   ///< t - value, rounded
};

/// |computed - exact| in ulps of the float at exact; infinity for NaN. computed may be a double that is no float.
[[nodiscard]] double ulp_error_f32(double computed, const Exact& exact);

/// |computed - exact| in ulps of the double at exact; infinity for NaN.
[[nodiscard]] double ulp_error_f64(double computed, const Exact& exact);

/// |exact - bound| / max(|exact|, |bound|): 0 where they are equal, infinity where bound is infinite.
[[nodiscard]] double relative_gap(const Exact& exact, double bound);

}  // namespace strahl::oracle
