// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstdint>
#include <cstring>

#include "cl/host_features.h"
#include "cl/math_tiers.h"

#define REAL_BITS 32
namespace f32 {
#include "portable.h"
// OpenCL's, for scene/counters.h.
inline void atomic_inc(uint* counter) { ++*counter; }
#include "film/film.h"
#include "film/splat.h"
#include "math/soft_fma.h"
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
}  // namespace f32

namespace strahl::test {

std::array<float, 3> normalize3(const std::array<float, 3>& v) {
  const f32::real3 n = f32::normalize3(f32::vec3(v[0], v[1], v[2]));
  return {n.x, n.y, n.z};
}
float length3(const std::array<float, 3>& v) { return f32::length3(f32::vec3(v[0], v[1], v[2])); }
float difference_of_products(float a, float b, float c, float d) { return f32::difference_of_products(a, b, c, d); }
float soft_fma(float a, float b, float c) { return f32::soft_fma(a, b, c); }
float random_unit(float, std::uint32_t bits) { return f32::random_unit_w_1(bits); }
float exp_minus(float a) { return f32::exp_minus_w_1(a); }
float minus_log(float u) { return f32::minus_log_w_1(u); }
float erfcx(float a) { return f32::erfcx_w_1(a); }
float erf_inverse(float share) { return f32::erf_inverse_w_1(share); }
void add_to_film(FilmWords& sum, float value, std::array<std::uint32_t, 4>* counts) {
  const f32::Scene scene{nullptr, nullptr, nullptr, counts->data(), nullptr};
  f32::film_add_sample(&scene, sum.data(), value);
}
void add_splat(SplatWords& sum, float value, std::array<std::uint32_t, 4>* counts) {
  static_assert(std::tuple_size_v<SplatWords> == f32::SPLAT_WORDS);
  const f32::Scene scene{nullptr, nullptr, nullptr, counts->data(), nullptr};
  f32::splat_channel(&scene, sum.data(), value);
}
void add_by_integers(FilmWords& sum, float value, int times) {
  std::array<std::uint32_t, 4> counts{};
  const f32::Scene scene{nullptr, nullptr, nullptr, counts.data(), nullptr};
  f32::film_add_slowly(&scene, sum.data(), value, times);
}

}  // namespace strahl::test
