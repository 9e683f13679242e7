// SPDX-License-Identifier: MIT
// cl/math, cl/film/film.h and splat.h of both tiers on the host, side by side; compiled in math_f32.cpp and
// math_f64.cpp.
#pragma once

#include <array>
#include <cstdint>

namespace strahl::test {

std::array<float, 3> normalize3(const std::array<float, 3>& v);
std::array<double, 3> normalize3(const std::array<double, 3>& v);
float length3(const std::array<float, 3>& v);
double length3(const std::array<double, 3>& v);
float difference_of_products(float a, float b, float c, float d);
double difference_of_products(double a, double b, double c, double d);

/// cl/math/soft_fma.h.
float soft_fma(float a, float b, float c);

std::array<std::uint32_t, 4> random4(std::uint32_t pixel, std::uint32_t sample, std::uint32_t dimension,
                                     std::uint32_t seed);
float random_unit(float tier, std::uint32_t bits);
double random_unit(double tier, std::uint32_t bits);

/// cl/math/exp_log_lanes.h, cl/math/erfc_lanes.h.
float exp_minus(float a);
double exp_minus(double a);
float minus_log(float u);
double minus_log(double u);
float erfcx(float a);
double erfcx(double a);
float erf_inverse(float share);
double erf_inverse(double share);

/// A channel's sum in the film: the words of cl/film/film_sum.h.
using FilmWords = std::array<std::int64_t, 2>;

/// Adds one sample as the kernel does. counts: saturated, invalid.
void add_to_film(FilmWords& sum, float value, std::array<std::uint32_t, 4>* counts);
void add_to_film(FilmWords& sum, double value, std::array<std::uint32_t, 4>* counts);
/// The same by integers alone, `times` times at once.
void add_by_integers(FilmWords& sum, float value, int times);
void add_by_integers(FilmWords& sum, double value, int times);

/// A channel's sum in the film of light paths: the words of cl/film/splat.h.
using SplatWords = std::array<std::int64_t, 9>;

/// Adds one splat as the kernel does. counts: saturated, invalid.
void add_splat(SplatWords& sum, float value, std::array<std::uint32_t, 4>* counts);
void add_splat(SplatWords& sum, double value, std::array<std::uint32_t, 4>* counts);

}  // namespace strahl::test
