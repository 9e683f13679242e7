// SPDX-License-Identifier: MIT
// Maps of the unit square against the moments of what they should cover, and places drawn on emitters: uniform by chi^2
// over bins of equal share, on the surface, with the density that a ray which found them would be given. 1 s.
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "cl/sampling_tiers.h"

using namespace strahl::test;

namespace {

template <class Real>
using Map = Triple<Real> (*)(Real, Real);

/// Mean of x^i y^j z^k over a grid of the square.
template <class Real>
double moment(Map<Real> map, int i, int j, int k) {
  constexpr int n = 256;
  double sum = 0;
  for (int a = 0; a < n; ++a)
    for (int b = 0; b < n; ++b) {
      const auto [x, y, z] = map(static_cast<Real>((a + 0.5) / n), static_cast<Real>((b + 0.5) / n));
      sum += std::pow(x, i) * std::pow(y, j) * std::pow(z, k);
    }
  return sum / (n * n);
}

template <class Real>
double length(const Triple<Real>& v) {
  return std::sqrt(double{v[0]} * v[0] + double{v[1]} * v[1] + double{v[2]} * v[2]);
}
template <class Real>
double dot(const Triple<Real>& a, const Triple<Real>& b) {
  return double{a[0]} * b[0] + double{a[1]} * b[1] + double{a[2]} * b[2];
}
template <class Real>
Triple<Real> minus(const Triple<Real>& a, const Triple<Real>& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

constexpr int bins = 8;

/// Draws points, sorts them by two coordinates in [0, 1) that are uniform if the points are; returns chi^2 per degree
/// of freedom.
template <class Real>
double chi_square(const std::function<std::array<double, 2>(Real, Real)>& place) {
  constexpr std::uint32_t count = 40000;
  std::vector<double> hits(bins * bins, 0);
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto [x, y] = independent_pair(i, 0, 0, 5);
    const auto [a, b] = place(Maps<Real>::between(x), Maps<Real>::between(y));
    const int column = std::min(static_cast<int>(a * bins), bins - 1),
              row = std::min(static_cast<int>(b * bins), bins - 1);
    ++hits.at(static_cast<std::size_t>(row * bins + column));
  }
  const double expected = static_cast<double>(count) / (bins * bins);
  double sum = 0;
  for (const double n : hits) sum += (n - expected) * (n - expected) / expected;
  return sum / (bins * bins - 1);
}

double turns(double y, double x) {
  const double a = std::atan2(y, x) / (2 * std::numbers::pi);
  return a < 0 ? a + 1 : a;
}

/// An area light of one item; uniform: where a point lies, in coordinates that are uniform.
template <class Real>
void hold(AreaKind kind, double inverse_area, double side, const std::vector<double>& item, const Triple<Real>& from,
          const std::function<std::array<double, 2>(const Triple<Real>&)>& uniform) {
  std::vector<Real> area{1, 1, 1, static_cast<Real>(inverse_area), static_cast<Real>(side)};
  for (const double x : item) area.push_back(static_cast<Real>(x));
  double worst = 0;
  const double chi = chi_square<Real>([&](Real u, Real v) {
    const DrawnPoint<Real> p = Maps<Real>::point(kind, area.data(), from, u, v);
    const Triple<Real> towards = minus(p.position, from);
    CHECK(length(p.normal) == Approx(1).epsilon(1e-5));
    const double found = Maps<Real>::density(kind, area.data(), from, towards, p.normal);
    // Not where the surface is seen so slantingly that its cosine has few digits.
    if (dot(p.normal, towards) < -0.02 * length(towards) && kind != AreaKind::sphere) {
      const double distance = length(towards);
      const double exact = -inverse_area * std::pow(distance, 3) / dot(p.normal, towards);
      worst = std::max(worst, std::fabs(p.density / exact - 1));
    }
    if (p.density > 0)
      worst = std::max(worst, std::fabs(found / p.density - 1));
    else if (found != 0)
      worst = 1;
    return uniform(p.position);
  });
  INFO("kind " << static_cast<int>(kind));
  CHECK(worst < 1e-4);
  // 63 degrees of freedom: standard deviation 0.18.
  CHECK(chi < 1.8);
  CHECK(chi > 0.4);
}

}  // namespace

TEMPLATE_TEST_CASE("the maps of the square have the moments of what they cover", "", float, double) {
  using M = Maps<TestType>;
  const auto hold_moment = [](Map<TestType> map, int i, int j, int k, double expected) {
    INFO(i << " " << j << " " << k);
    CHECK(moment<TestType>(map, i, j, k) == Approx(expected).margin(2e-4));
  };
  hold_moment(M::disk, 1, 0, 0, 0);
  hold_moment(M::disk, 2, 0, 0, 0.25);
  hold_moment(M::disk, 0, 2, 0, 0.25);
  hold_moment(M::disk, 4, 0, 0, 0.125);
  hold_moment(M::disk, 2, 2, 0, 1.0 / 24);
  hold_moment(M::cosine_hemisphere, 0, 0, 1, 2.0 / 3);
  hold_moment(M::cosine_hemisphere, 0, 0, 2, 0.5);
  hold_moment(M::cosine_hemisphere, 2, 0, 0, 0.25);
  hold_moment(M::cosine_hemisphere, 0, 0, 4, 1.0 / 3);
  hold_moment(M::sphere, 0, 0, 1, 0);
  for (int axis = 0; axis < 3; ++axis) {
    hold_moment(M::sphere, 2 * (axis == 0), 2 * (axis == 1), 2 * (axis == 2), 1.0 / 3);
    hold_moment(M::sphere, 4 * (axis == 0), 4 * (axis == 1), 4 * (axis == 2), 0.2);
    hold_moment(M::triangle, axis == 0, axis == 1, axis == 2, 1.0 / 3);
    hold_moment(M::triangle, 2 * (axis == 0), 2 * (axis == 1), 2 * (axis == 2), 1.0 / 6);
  }
  hold_moment(M::triangle, 1, 1, 0, 1.0 / 12);
}

TEMPLATE_TEST_CASE("at the corners and in the middle of the square nothing leaves its range", "", float, double) {
  using M = Maps<TestType>;
  for (const std::uint32_t a : {0u, 0x7fffffffu, 0x80000000u, 0xffffffffu})
    for (const std::uint32_t b : {0u, 0x7fffffffu, 0x80000000u, 0xffffffffu}) {
      const TestType u = M::between(a), v = M::between(b);
      CHECK(length(M::disk(u, v)) < 1.000001);
      CHECK(length(M::cosine_hemisphere(u, v)) == Approx(1).epsilon(1e-6));
      CHECK(M::cosine_hemisphere(u, v)[2] > 0);
      CHECK(length(M::sphere(u, v)) == Approx(1).epsilon(1e-6));
      for (const TestType weight : M::triangle(u, v)) CHECK(weight >= -1e-7);
    }
}

TEMPLATE_TEST_CASE("frames are right-handed and orthonormal", "", float, double) {
  for (std::uint32_t i = 0; i < 1000; ++i) {
    const auto [a, b] = independent_pair(i, 0, 0, 9);
    Triple<TestType> n = Maps<TestType>::sphere(Maps<TestType>::between(a), Maps<TestType>::between(b));
    if (i < 6) {
      n = {0, 0, 0};
      n[i % 3] = i < 3 ? TestType(1) : TestType(-1);
    }
    const auto [x, y] = Maps<TestType>::frame(n);
    const Triple<TestType> z{x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]};
    CHECK(std::fabs(dot(x, y)) < 1e-6);
    CHECK(std::fabs(dot(x, x) - 1) < 1e-6);
    CHECK(std::fabs(dot(y, y) - 1) < 1e-6);
    CHECK(length(minus(z, n)) < 1e-6);
  }
}

TEMPLATE_TEST_CASE("places on flat emitters are uniform", "", float, double) {
  const Triple<TestType> from{TestType(0.3), TestType(-0.5), TestType(2)};
  const std::vector<double> item{1, 2, 0, 3, 0, 0, 0, 2, 0, 0, 0, 1};
  hold<TestType>(AreaKind::parallelogram, 1.0 / 6, 1, item, from, [](const auto& p) {
    return std::array{(p[0] - 1.0) / 3, (p[1] - 2.0) / 2};
  });
  hold<TestType>(AreaKind::triangle, 1.0 / 3, 1, item, from, [](const auto& p) {
    const double u = (p[0] - 1.0) / 3, v = (p[1] - 2.0) / 2;
    // A strip towards the first corner has an area in proportion to the square of its distance.
    return std::array{(u + v) * (u + v), v / (u + v)};
  });
  hold<TestType>(AreaKind::disk, 1 / (4 * std::numbers::pi), 1, {1, 2, 0, 2, 0, 0, 0, 2, 0, 0, 0, 1}, from,
                 [](const auto& p) {
                   const double x = (p[0] - 1.0) / 2, y = (p[1] - 2.0) / 2;
                   return std::array{x * x + y * y, turns(y, x)};
                 });
}

TEMPLATE_TEST_CASE("places on a cylinder are uniform", "", float, double) {
  hold<TestType>(AreaKind::cylinder, 1 / (2 * std::numbers::pi * 0.5 * 3), 1, {0, 0, 0, 0, 0, 3, 0.5, 0, 0, 0, 0.5, 0},
                 {2, 1, 1}, [](const auto& p) {
                   return std::array{turns(p[1], p[0]), p[2] / 3.0};
                 });
}

TEMPLATE_TEST_CASE("a sphere's directions are uniform in its cone, its places from inside on its area", "", float,
                   double) {
  for (const double distance : {1.001, 1.5, 1e4}) {
    INFO(distance);
    const Triple<TestType> from{0, 0, static_cast<TestType>(distance)};
    const double d = from[2], cosine = std::sqrt((d - 1) * (d + 1)) / d, less = 1 / (d * d) / (1 + cosine);
    hold<TestType>(AreaKind::sphere, 1, 1, {0, 0, 0, 1}, from, [&](const auto& p) {
      CHECK(length(p) == Approx(1).epsilon(1e-5));
      const double across = std::hypot(double{p[0]}, double{p[1]}), along = d - double{p[2]};
      // 1 - cos of the direction over that of the cone, by the sine, which keeps its digits.
      const double tangent = across / along, root = std::sqrt(1 + tangent * tangent);
      return std::array{tangent * tangent / (root * (1 + root)) / less, turns(p[1], p[0])};
    });
  }
  hold<TestType>(AreaKind::sphere, 1 / (4 * std::numbers::pi), -1, {0, 0, 0, 1}, {0, TestType(0.5), 0},
                 [](const auto& p) {
                   return std::array{0.5 + 0.5 * p[2], turns(p[1], p[0])};
                 });
}
