// SPDX-License-Identifier: MIT
#include "oracle/exact.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace strahl::oracle {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// long double has a wider exponent than double: neither 2^1024 nor a difference of extremes overflows.
template <class Float>
long double finite_stand_in(double x) {
  if (!std::isinf(x)) return x;
  return std::copysign(std::ldexp(1.0L, std::numeric_limits<Float>::max_exponent), static_cast<long double>(x));
}

/// In ulps of Float, whatever the format of computed.
template <class Float>
double ulp_error(double computed, const Exact& exact) {
  using Limits = std::numeric_limits<Float>;
  if (std::isnan(computed) || std::isnan(exact.value)) return infinity;
  const long double limit = std::ldexp(1.0L, Limits::max_exponent);
  const long double reference = finite_stand_in<double>(exact.value);
  if (std::isinf(computed) && std::fabs(reference) >= limit && std::signbit(computed) == std::signbit(exact.value))
    return 0;
  int exponent = Limits::min_exponent - 1;
  if (reference != 0) {
    int binade;
    const bool power_of_two = std::fabs(std::frexp(reference, &binade)) == 0.5L;
    const bool finer = power_of_two && (exact.rest == 0 || std::signbit(exact.rest) != std::signbit(exact.value));
    exponent = std::clamp(binade - (finer ? 2 : 1), Limits::min_exponent - 1, Limits::max_exponent - 1);
  }
  const long double difference = (finite_stand_in<Float>(computed) - reference) - exact.rest;
  return static_cast<double>(std::ldexp(std::fabs(difference), Limits::digits - 1 - exponent));
}

}  // namespace

double ulp_error_f32(double computed, const Exact& exact) { return ulp_error<float>(computed, exact); }

double ulp_error_f64(double computed, const Exact& exact) { return ulp_error<double>(computed, exact); }

double relative_gap(const Exact& exact, double bound) {
  if (std::isinf(bound)) return infinity;
  const long double difference = (static_cast<long double>(exact.value) - bound) + exact.rest;
  if (difference == 0) return 0;
  return static_cast<double>(std::fabs(difference) / std::max(std::fabs(exact.value), std::fabs(bound)));
}

}  // namespace strahl::oracle
