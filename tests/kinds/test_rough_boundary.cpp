// SPDX-License-Identifier: MIT
// What rough boundaries let through: nearly smooth ones by Fresnel's equations, at cosines between the fit's nodes too;
// rough ones before something thinner by draws of microfacets.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <random>

#include "kinds/rough_boundary.h"

using namespace strahl;
using kinds::RoughBoundary;

namespace {

double through(const RoughBoundary& boundary, double cosine) {
  double sum = 0;
  for (const double term : boundary.through) sum = sum * (2 * cosine - 0.5) / (cosine + 0.5) + term;
  return sum;
}

double smooth(double c, double eta) {
  const double t2 = 1 - (1 - c * c) / (eta * eta);
  if (t2 <= 0) return 0;
  const double t = std::sqrt(t2);
  const double s = (c - eta * t) / (c + eta * t), p = (eta * c - t) / (eta * c + t);
  return 1 - (s * s + p * p) / 2;
}

/// Of Beckmann's microfacets, by draws of their slopes.
double drawn(double alpha, double eta, double cosine) {
  std::mt19937_64 engine(7);
  std::normal_distribution<double> slope(0, alpha / std::numbers::sqrt2);
  const double sine = std::sqrt(1 - cosine * cosine);
  double seen = 0, through = 0;
  for (int i = 0; i < 400000; ++i) {
    const double x = slope(engine), length = std::sqrt(1 + x * x + std::pow(slope(engine), 2));
    const double c = (cosine - sine * x) / length;
    if (c <= 0) continue;
    seen += c * length;
    const double t2 = 1 - (1 - c * c) / (eta * eta);
    if (t2 <= 0) continue;
    const double z = cosine / eta - (c / eta - std::sqrt(t2)) / length;
    if (z <= 0) continue;
    const double a = z / (alpha * std::sqrt(std::max(1 - z * z, 1e-12)));
    const double masking = a >= 1.6 ? 1 : (3.535 * a + 2.181 * a * a) / (1 + 2.276 * a + 2.577 * a * a);
    through += c * length * smooth(c, eta) * masking;
  }
  return through / seen;
}

/// What comes back of evenly spread light from inside, at the 64 cosines that Mitsuba adds up, by draws of slopes.
double drawn_inner(MicrofacetKind kind, double alpha, double eta) {
  std::mt19937_64 engine(11);
  std::uniform_real_distribution<double> unit(0, 1);
  double mean = 0;
  for (int k = 0; k < 64; ++k) {
    const double cosine = std::max(1e-6, k / 63.0), sine = std::sqrt(1 - cosine * cosine);
    double seen = 0, back = 0;
    for (int i = 0; i < 8000; ++i) {
      const double u = unit(engine), angle = 2 * std::numbers::pi * unit(engine);
      const double slope = alpha * (kind == MicrofacetKind::ggx ? std::sqrt(u / (1 - u)) : std::sqrt(-std::log(1 - u)));
      const double length = std::hypot(slope, 1), c = (cosine - sine * slope * std::cos(angle)) / length;
      if (c <= 0) continue;
      seen += c * length;
      const double z = 2 * c / length - cosine, across = alpha * std::sqrt(std::max(1 - z * z, 1e-12));
      if (z <= 0) continue;
      const double a = z / across;
      const double beckmann = a >= 1.6 ? 1 : (3.535 * a + 2.181 * a * a) / (1 + 2.276 * a + 2.577 * a * a);
      const double masking = kind == MicrofacetKind::ggx ? 2 * z / (z + std::hypot(z, across)) : beckmann;
      back += c * length * (1 - smooth(std::min(c, 1.0), 1 / eta)) * masking;
    }
    mean += 2.0 / 64 * cosine * back / seen;
  }
  return mean;
}

}  // namespace

TEST_CASE("a boundary that is hardly rough lets through what Fresnel's equations say") {
  for (const MicrofacetKind kind : {MicrofacetKind::beckmann, MicrofacetKind::ggx})
    for (const double eta : {1.33, 1.49, 1.9}) {
      const RoughBoundary boundary = kinds::rough_boundary(kind, 1e-4, eta);
      for (int i = 1; i <= 100; ++i) {
        INFO("eta " << eta << ", cosine " << i / 100.0);
        CHECK(through(boundary, i / 100.0) == Approx(smooth(i / 100.0, eta)).margin(1e-3));
      }
    }
}

TEST_CASE("before something thinner it lets nothing through from the critical angle on") {
  for (const MicrofacetKind kind : {MicrofacetKind::beckmann, MicrofacetKind::ggx})
    for (const double eta : {0.4, 0.671, 0.75, 0.9}) {
      const RoughBoundary boundary = kinds::rough_boundary(kind, 1e-4, eta);
      for (int i = 1; i <= 100; ++i) {
        INFO("eta " << eta << ", cosine " << i / 100.0);
        CHECK(kinds::share_through(boundary, eta, i / 100.0) == Approx(smooth(i / 100.0, eta)).margin(3e-3));
      }
    }
}

TEST_CASE("rough boundaries before something thinner let through what draws of their microfacets do") {
  for (const double alpha : {0.05, 0.1, 0.3})
    for (const double eta : {0.5, 0.671, 0.9}) {
      const RoughBoundary boundary = kinds::rough_boundary(MicrofacetKind::beckmann, alpha, eta);
      for (const double cosine : {0.05, 0.2, 0.35, 0.5, 0.6, 0.7, 0.74, 0.8, 0.9, 0.99}) {
        INFO("alpha " << alpha << ", eta " << eta << ", cosine " << cosine);
        // The draws' own error is within 0.002.
        CHECK(kinds::share_through(boundary, eta, cosine) == Approx(drawn(alpha, eta, cosine)).margin(6e-3));
      }
    }
}

TEST_CASE("rough boundaries reflect as much of the diffuse light from within as draws of their microfacets do") {
  for (const MicrofacetKind kind : {MicrofacetKind::beckmann, MicrofacetKind::ggx})
    for (const double alpha : {0.03, 0.085, 0.3})
      for (const double eta : {1.49, 1.9152}) {
        INFO("alpha " << alpha << ", eta " << eta);
        // A diffuse base is as bright as what does not come back is.
        const double inner = kinds::rough_boundary(kind, alpha, eta).inner;
        CHECK((1 - inner) / (1 - drawn_inner(kind, alpha, eta)) == Approx(1).margin(2e-3));
      }
}

TEST_CASE("of nearly equal indices nearly all evenly spread light goes through") {
  for (const MicrofacetKind kind : {MicrofacetKind::beckmann, MicrofacetKind::ggx})
    for (const double alpha : {1e-4, 0.01}) {
      const RoughBoundary boundary = kinds::rough_boundary(kind, alpha, 0.999999);
      double sum = 0;
      for (int i = 0; i < 100; ++i) {
        const double cosine = (i + 0.5) / 100;
        sum += 2 * cosine * kinds::share_through(boundary, 0.999999, cosine) / 100;
      }
      INFO("alpha " << alpha);
      CHECK(sum == Approx(1).margin(2e-3));
    }
}

TEST_CASE("boundaries before something denser keep the polynomial of the cosine") {
  const RoughBoundary boundary = kinds::rough_boundary(MicrofacetKind::beckmann, 0.1, 1.49);
  CHECK(boundary.soft == 0);
  CHECK(boundary.spread == 0.5);
  CHECK(kinds::share_through(boundary, 1.49, 0.37) == Approx(through(boundary, 0.37)).epsilon(1e-12));
}

TEST_CASE("of the densest inside some light is let out") {
  for (const MicrofacetKind kind : {MicrofacetKind::beckmann, MicrofacetKind::ggx})
    for (const double alpha : {1e-4, 1e-3, 0.1})
      for (const double eta : {1e3, 1e5, 1e9}) {
        INFO("alpha " << alpha << ", eta " << eta);
        const double inner = kinds::rough_boundary(kind, alpha, eta).inner;
        CHECK(inner > 0.9);
        CHECK(inner <= kinds::largest_inner_reflectance);
      }
}

TEST_CASE("rougher boundaries let more through where light is shallow, less where it is steep") {
  for (const MicrofacetKind kind : {MicrofacetKind::beckmann, MicrofacetKind::ggx}) {
    const RoughBoundary fine = kinds::rough_boundary(kind, 0.05, 1.5), rough = kinds::rough_boundary(kind, 0.5, 1.5);
    CHECK(through(rough, 0.05) > through(fine, 0.05));
    CHECK(through(rough, 1) < through(fine, 1));
    CHECK(fine.inner == Approx(0.58).margin(0.01));
  }
}

TEST_CASE("a smooth boundary reflects less than all of the diffuse light from within, whatever its index") {
  double before = 0;
  for (const double eta : {1.05, 1.5, 2.0, 2.9, 3.0, 3.01, 3.5, 3.84, 3.85, 3.9, 4.0, 5.0, 100.0, 1e4, 1e6}) {
    INFO(eta);
    const double inner = kinds::smooth_inner_reflectance(eta);
    CHECK(inner >= before);
    CHECK(static_cast<float>(inner) < 1);
    before = inner;
  }
  // Mitsuba's up to 3; from there on what let-out light in proportion to 1 / eta^2 leaves.
  CHECK(kinds::smooth_inner_reflectance(3) == Approx(0.93554).margin(1e-5));
  CHECK(kinds::smooth_inner_reflectance(6) == Approx(1 - (1 - 0.93554) / 4).margin(1e-5));
}
