// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstdint>
#include <cstring>

#include "cl/host_features.h"
#include "cl/math_tiers.h"

#define REAL_BITS 64
namespace f64 {
#include "portable.h"
// OpenCL's, for scene/counters.h.
inline void atomic_inc(uint* counter) { ++*counter; }
#include "film/film.h"
#include "film/splat.h"
#include "math/vec3.h"
#define LANES 1
#include "lanes/lane_ops.h"
// It is written in them.
#include "math/rng_lanes.h"
// As above.
#include "math/erfc_lanes.h"
#include "math/exp_log_lanes.h"
// Needs the one above.
#include "math/erf_inverse_lanes.h"
}  // namespace f64

namespace strahl::test {

std::array<double, 3> normalize3(const std::array<double, 3>& v) {
  const f64::real3 n = f64::normalize3(f64::vec3(v[0], v[1], v[2]));
  return {n.x, n.y, n.z};
}
double length3(const std::array<double, 3>& v) { return f64::length3(f64::vec3(v[0], v[1], v[2])); }
double difference_of_products(double a, double b, double c, double d) {
  return f64::difference_of_products(a, b, c, d);
}
std::array<std::uint32_t, 4> random4(std::uint32_t pixel, std::uint32_t sample, std::uint32_t dimension,
                                     std::uint32_t seed) {
  const f64::Random4_w_1 r = f64::random4_w_1(pixel, sample, dimension, seed);
  return {r.x, r.y, r.z, r.w};
}
double random_unit(double, std::uint32_t bits) { return f64::random_unit_w_1(bits); }
double exp_minus(double a) { return f64::exp_minus_w_1(a); }
double minus_log(double u) { return f64::minus_log_w_1(u); }
double erfcx(double a) { return f64::erfcx_w_1(a); }
double erf_inverse(double share) { return f64::erf_inverse_w_1(share); }
void add_to_film(FilmWords& sum, double value, std::array<std::uint32_t, 4>* counts) {
  const f64::Scene scene{nullptr, nullptr, nullptr, counts->data(), nullptr};
  f64::film_add_sample(&scene, sum.data(), value);
}
void add_splat(SplatWords& sum, double value, std::array<std::uint32_t, 4>* counts) {
  static_assert(std::tuple_size_v<SplatWords> == f64::SPLAT_WORDS);
  const f64::Scene scene{nullptr, nullptr, nullptr, counts->data(), nullptr};
  f64::splat_channel(&scene, sum.data(), value);
}
void add_by_integers(FilmWords& sum, double value, int times) {
  std::array<std::uint32_t, 4> counts{};
  const f64::Scene scene{nullptr, nullptr, nullptr, counts.data(), nullptr};
  f64::film_add_slowly(&scene, sum.data(), value, times);
}

}  // namespace strahl::test
