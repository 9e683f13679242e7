// SPDX-License-Identifier: MIT
// Vectors and affine maps against closed forms, at ordinary and at extreme scales.
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "scene/model/perpendicular.h"
#include "scene/model/vec.h"

using namespace strahl;

namespace {

void check_close(const Vec3& a, const Vec3& b, double tolerance) { CHECK(length(a - b) <= tolerance); }

}  // namespace

TEST_CASE("products") {
  CHECK(dot({1, 2, 3}, {4, -5, 6}) == 12);
  CHECK(cross({1, 0, 0}, {0, 1, 0}) == Vec3{0, 0, 1});
  CHECK(length({2, 3, 6}) == 7);
  CHECK_FALSE(is_finite(Vec3{0, std::nan(""), 0}));
  CHECK_FALSE(is_finite(Vec3{0, 0, INFINITY}));
}

TEST_CASE("normalisation neither overflows nor underflows") {
  for (const double scale : {1.0, 1e300, 1e-300, 5e-324 * 64}) {
    const Vec3 n = normalized({3 * scale, 0, 4 * scale});
    CHECK(n.x == Approx(0.6).epsilon(1e-15));
    CHECK(n.z == Approx(0.8).epsilon(1e-15));
  }
}

TEST_CASE("what has no direction is no unit vector") {
  for (const Vec3& none : {Vec3{}, Vec3{-0.0, 0, 0}, Vec3{std::nan(""), 1, 0}, Vec3{1, 0, std::nan("")}}) {
    const Vec3 n = normalized(none);
    CHECK((std::isnan(n.x) && std::isnan(n.y) && std::isnan(n.z)));
  }
}

TEST_CASE("orthonormal basis is right-handed everywhere") {
  std::mt19937 random(1);
  std::normal_distribution<double> gauss;
  for (int i = 0; i < 1000; ++i) {
    const Vec3 n = i == 0 ? Vec3{0, 0, -1} : normalized({gauss(random), gauss(random), gauss(random)});
    const auto [s, t] = orthonormal_basis(n);
    check_close(cross(s, t), n, 1e-15);
    CHECK(std::abs(dot(s, t)) < 1e-15);
    CHECK(length(s) == Approx(1).epsilon(1e-15));
  }
}

TEST_CASE("what is perpendicular to a unit vector is so in all digits, however near the two are") {
  const Vec3 n = normalized({1, 2, 2});
  const auto [s, t] = orthonormal_basis(n);
  check_close(perpendicular(3.0 * s + 4.0 * n, n), s, 1e-15);
  for (const double off : {1e-1, 1e-2, 1e-3, 1e-9, 0.0}) {
    const Vec3 across = perpendicular(n + off * t, n);
    CHECK(std::abs(dot(across, n)) < 1e-13);
    CHECK(length(across) == Approx(1).epsilon(1e-15));
  }
}

TEST_CASE("normals keep perpendicular to transformed surfaces") {
  const Transform t{{{{1, 2, 0, 7}, {0, 3, 1, 8}, {-1, 0, 2, 9}}}};
  CHECK(t.determinant() == 4);
  const Vec3 a{1, 2, 3}, b{-2, 1, 0.5}, n = cross(a, b);
  CHECK(std::abs(dot(t.normal(n), t.vector(a))) < 1e-14);
  CHECK(std::abs(dot(t.normal(n), t.vector(b))) < 1e-14);
  CHECK(Transform{}.normal(n) == n);
  const Transform tiny{{{{1e-200, 0, 0, 0}, {0, 1e-200, 0, 0}, {0, 0, 1e-200, 0}}}};
  check_close(normalized(tiny.normal({0, 0, 1})), {0, 0, 1}, 1e-15);
}

TEST_CASE("composition applies the right factor first") {
  const Transform move{{{{1, 0, 0, 1}, {0, 1, 0, 2}, {0, 0, 1, 3}}}},
      scale{{{{2, 0, 0, 0}, {0, 2, 0, 0}, {0, 0, 2, 0}}}};
  CHECK((move * scale).point({1, 1, 1}) == Vec3{3, 4, 5});
  CHECK((scale * move).point({1, 1, 1}) == Vec3{4, 6, 8});
  CHECK((scale * move).vector({1, 1, 1}) == Vec3{2, 2, 2});
}

TEST_CASE("an inverse leads back, whatever the scale") {
  const Transform move{{{{1, 0, 0, 1}, {0, 1, 0, 2}, {0, 0, 1, 3}}}};
  CHECK(move.inverse().point({1, 2, 3}) == Vec3{0, 0, 0});
  const Transform t{{{{1, 2, 0, 7}, {0, 3, 1, 8}, {-1, 0, 2, 9}}}};
  for (const double scale : {1.0, 1e-150, 1e150}) {
    const Transform sized = t * Transform{{{{scale, 0, 0, 0}, {0, scale, 0, 0}, {0, 0, scale, 0}}}};
    const Vec3 p{0.5, -2, 3};
    check_close(scale * sized.inverse().vector(t.vector(p)), p, 1e-14);
    check_close(scale * sized.inverse().point(t.point(p)), p, 1e-14);
  }
}
