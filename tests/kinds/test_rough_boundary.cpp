// SPDX-License-Identifier: MIT
// What rough boundaries let through: nearly smooth ones by Fresnel's equations, at cosines between the fit's nodes too.
#include <catch2/catch.hpp>
#include <cmath>

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
  const double t = std::sqrt(1 - (1 - c * c) / (eta * eta));
  const double s = (c - eta * t) / (c + eta * t), p = (eta * c - t) / (eta * c + t);
  return 1 - (s * s + p * p) / 2;
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
