// SPDX-License-Identifier: MIT
// The generators' promises: the same cases from the same seed, floats where asked for, cases as hard as their law says.
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "oracle/generators.h"

using namespace strahl::oracle;

namespace {

constexpr int count = 2000;

template <class Shape>
std::vector<Case<Shape>> draw(Case<Shape> (*generate)(Random&, Law, Rounding), Law law, Rounding rounding) {
  Random random(7);
  std::vector<Case<Shape>> cases;
  for (int i = 0; i < count; ++i) cases.push_back(generate(random, law, rounding));
  return cases;
}

bool is_float(double x) { return std::isnan(x) || x == static_cast<double>(static_cast<float>(x)); }
bool is_float(const strahl::Vec3& v) { return is_float(v.x) && is_float(v.y) && is_float(v.z); }
bool is_float(const Ray& r) {
  return is_float(r.origin) && is_float(r.direction) && is_float(r.t_min) && is_float(r.t_max);
}

}  // namespace

TEST_CASE("the generator is SplitMix64") {
  Random random(1234567);
  CHECK(random.bits() == 6457827717110365317u);
  CHECK(random.bits() == 3203168211198807973u);
}

TEST_CASE("a seed gives the same cases again") {
  for (const Law law : all_laws) {
    const auto a = draw(triangle_case, law, Rounding::to_double), b = draw(triangle_case, law, Rounding::to_double);
    bool is_same = true;
    for (std::size_t i = 0; i < a.size(); ++i)
      is_same = is_same && a[i].ray.origin == b[i].ray.origin && a[i].shape.p2 == b[i].shape.p2;
    CHECK(is_same);
    CHECK_FALSE(a[0].ray.origin == a[1].ray.origin);
  }
}

TEST_CASE("rounded to float, every number is a finite float and double cases are not") {
  for (const Law law : all_laws) {
    INFO(static_cast<int>(law));
    bool all_float = true, all_finite = true;
    for (const auto& [ray, shape] : draw(sphere_case, law, Rounding::to_float)) {
      all_float = all_float && is_float(ray) && is_float(shape.center) && is_float(shape.radius);
      all_finite = all_finite && std::isfinite(ray.origin.x + ray.direction.x + shape.center.x + shape.radius);
    }
    for (const auto& [ray, shape] : draw(aabb_case, law, Rounding::to_float))
      all_float = all_float && is_float(ray) && is_float(shape.min) && is_float(shape.max);
    for (const auto& [ray, shape] : draw(cylinder_case, law, Rounding::to_float))
      all_float = all_float && is_float(ray) && is_float(shape.p0) && is_float(shape.axis) && is_float(shape.radius);
    CHECK(all_float);
    CHECK(all_finite);
  }
  int floats = 0;
  for (const auto& c : draw(sphere_case, Law::aimed, Rounding::to_double)) floats += is_float(c.shape.center);
  CHECK(floats < count / 100);
}

TEST_CASE("tangent-seeking spheres are 2^-25 to 2^-9 from tangent, on both sides") {
  int in = 0, out = 0, in_band = 0;
  for (const auto& [ray, shape] : draw(sphere_case, Law::border, Rounding::to_float)) {
    const double margin = sphere(ray, shape).margin;
    ++(margin >= 0 ? in : out);
    // margin = 1 - (L / r)^2 is twice 1 - L / r; the radius' own rounding may halve the smallest.
    in_band += std::fabs(margin) <= 0x1p-8 && std::fabs(margin) >= 0x1p-25;
  }
  CHECK(in > count / 3);
  CHECK(out > count / 3);
  CHECK(in_band > count * 9 / 10);
}

TEST_CASE("exact laws hit the border exactly, whatever the shape") {
  for (const auto& [ray, shape] : draw(sphere_case, Law::exact_border, Rounding::to_float))
    REQUIRE(sphere(ray, shape).discriminant_sign == 0);
  int corners = 0, in_face = 0;
  for (const auto& [ray, shape] : draw(aabb_case, Law::exact_border, Rounding::to_float)) {
    REQUIRE(aabb(ray, shape).line_meets);
    corners += aabb(ray, shape).margin == 0;
  }
  CHECK(corners > count / 10);
  for (const auto& [ray, shape] : draw(aabb_case, Law::in_surface, Rounding::to_float))
    in_face += aabb(ray, shape).line_meets;
  CHECK(in_face > count / 4);
  int tangent = 0;
  for (const auto& [ray, shape] : draw(cylinder_case, Law::exact_border, Rounding::to_float))
    tangent += cylinder(ray, shape).margin == 0;
  CHECK(tangent > count / 2);
}

TEST_CASE("axis-parallel rays have zero components of both signs, unnormalised ones span 38 decades") {
  int zeros = 0, negative_zeros = 0;
  for (const auto& c : draw(triangle_case, Law::axis_parallel, Rounding::to_float))
    for (const double x : {c.ray.direction.x, c.ray.direction.y, c.ray.direction.z}) {
      zeros += x == 0;
      negative_zeros += x == 0 && std::signbit(x);
    }
  CHECK(zeros > count);
  CHECK(negative_zeros > zeros / 3);
  double least = 1, most = 1;
  for (const auto& c : draw(disk_case, Law::unnormalised, Rounding::to_float)) {
    const auto [x, y, z] = c.ray.direction;
    const double length = std::sqrt(x * x + y * y + z * z);
    least = std::fmin(least, length);
    most = std::fmax(most, length);
  }
  CHECK(least < 1e-19);
  CHECK(most > 1e17);
}
