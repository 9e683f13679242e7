// SPDX-License-Identifier: MIT
// The oracle against itself over every law of the generators: the filtered path equals the rational one, and the
// answers satisfy, in rationals, conditions that the solvers do not use.
#include <catch2/catch.hpp>
#include <cmath>
#include <string>

#include "oracle/generators.h"
#include "oracle/number.h"

using namespace strahl::oracle;
using Q = mpq_class;
using Vec = Vector<Q>;

namespace {

constexpr int cases_per_law = 400;

template <class Generate, class Check>
void over_all_laws(Generate generate, Check check) {
  for (const Law law : all_laws) {
    Random random(100 + static_cast<std::uint64_t>(law));
    for (int i = 0; i < cases_per_law; ++i) {
      const auto c = generate(random, law, i % 2 ? Rounding::to_float : Rounding::to_double);
      INFO("law " << static_cast<int>(law) << ", case " << i);
      check(c.ray, c.shape, law);
    }
  }
}

void require_same(const Exact& a, const Exact& b) {
  REQUIRE(a.value == b.value);
  REQUIRE(std::fabs(a.rest - b.rest) <= 0x1p-79 * std::fabs(a.value));
}

void require_same(const Answer& a, const Answer& b) {
  REQUIRE(a.hit == b.hit);
  if (a.hit) require_same(a.t, b.t);
  // Where the filter is sure of a sign only, the margin has few digits, but is tiny.
  if (std::isfinite(b.margin)) REQUIRE(a.margin == Approx(b.margin).epsilon(1e-12).margin(1e-22));
}

Q exactly(const Exact& t) { return Q(t.value) + Q(t.rest); }
Vec point_at(const Ray& ray, const Q& t) { return Vec(ray.origin) + t * Vec(ray.direction); }
bool is_within(const Ray& ray, const Q& t) { return in_range(ray, t); }
Q magnitude(const Q& a) { return abs(a); }

// | |p - c|^2 - r^2 | at the rounded root is at most |p - c| |d| times its error, which is below 2^-80 of t.
bool is_small(const Q& residual, const Ray& ray, const Exact& t, const Q& scale) {
  const Vec d(ray.direction);
  const Q step = magnitude(exactly(t)) * Q(0x1p-78);
  return residual * residual <=
         Q(4) * step * step * dot(d, d) * scale + step * step * step * step * dot(d, d) * dot(d, d);
}

}  // namespace

TEST_CASE("sphere: both paths agree, roots lie on the surface, b^2 - a c has the same sign") {
  int hits = 0, misses = 0;
  over_all_laws(sphere_case, [&](const Ray& ray, const Sphere& shape, Law) {
    const QuadricAnswer answer = sphere(ray, shape), rational = sphere(ray, shape, Arithmetic::rational);
    require_same(answer, rational);
    REQUIRE(answer.discriminant_sign == rational.discriminant_sign);
    const Vec d(ray.direction), f = Vec(ray.origin) - Vec(shape.center);
    const Q r2 = Q(shape.radius) * Q(shape.radius), b = dot(f, d);
    if (dot(d, d) == 0 || r2 == 0) return;
    REQUIRE(answer.discriminant_sign == sign(Q(b * b - dot(d, d) * (dot(f, f) - r2))));
    ++(answer.hit ? hits : misses);
    if (answer.discriminant_sign < 0) return;
    for (const Exact& root : answer.root) {
      const Vec p = point_at(ray, exactly(root)) - Vec(shape.center);
      REQUIRE(is_small(dot(p, p) - r2, ray, root, r2));
    }
  });
  CHECK(hits > 1000);
  CHECK(misses > 300);
}

TEST_CASE("cylinder: both paths agree, hits lie on the mantle and between the ends") {
  int hits = 0, misses = 0;
  over_all_laws(cylinder_case, [&](const Ray& ray, const Cylinder& shape, Law) {
    const QuadricAnswer answer = cylinder(ray, shape), rational = cylinder(ray, shape, Arithmetic::rational);
    require_same(answer, rational);
    REQUIRE(answer.on_shape == rational.on_shape);
    ++(answer.hit ? hits : misses);
    const Vec v(shape.axis), d(ray.direction);
    const Q v2 = dot(v, v), r2 = Q(shape.radius) * Q(shape.radius);
    if (answer.discriminant_sign < 0) return;
    for (std::size_t i = 0; i < 2; ++i) {
      const Vec p = point_at(ray, exactly(answer.root[i])) - Vec(shape.p0), across = cross(p, v);
      REQUIRE(is_small(Q(dot(across, across) / v2 - r2), ray, answer.root[i], r2));
      // The root is known to 2^-80 of itself only: within that of an end, the exact decision stands.
      const Q place = dot(p, v), slack = magnitude(exactly(answer.root[i])) * Q(0x1p-78) * magnitude(dot(d, v));
      if (answer.on_shape[i]) REQUIRE((place >= -slack && place <= v2 + slack));
      if (!answer.on_shape[i]) REQUIRE((place <= slack || place >= v2 - slack));
    }
  });
  CHECK(hits > 1000);
  CHECK(misses > 300);
}

TEST_CASE("plane: both paths agree, t solves the plane's equation") {
  int hits = 0, misses = 0;
  over_all_laws(plane_case, [&](const Ray& ray, const Plane& shape, Law law) {
    const Answer answer = plane(ray, shape);
    require_same(answer, plane(ray, shape, Arithmetic::rational));
    ++(answer.hit ? hits : misses);
    if (law == Law::exact_border || law == Law::in_surface) REQUIRE_FALSE(answer.hit);
    if (answer.margin <= 0) return;
    const Vec n(shape.normal);
    const Q residual = dot(n, point_at(ray, exactly(answer.t)) - Vec(shape.point));
    REQUIRE(magnitude(residual) <= Q(0x1p-78) * magnitude(exactly(answer.t) * dot(n, Vec(ray.direction))));
  });
  CHECK(hits > 1000);
  CHECK(misses > 300);
}

TEST_CASE("triangle: both paths agree, the three triple products (Plucker) give the same sides") {
  int hits = 0, misses = 0, edges = 0, vertices = 0;
  over_all_laws(triangle_case, [&](const Ray& ray, const Triangle& shape, Law law) {
    const PlanarAnswer answer = triangle(ray, shape), rational = triangle(ray, shape, Arithmetic::rational);
    require_same(answer, rational);
    REQUIRE(answer.edge_sign == rational.edge_sign);
    ++(answer.hit ? hits : misses);
    edges += answer.on_edge;
    vertices += answer.on_vertex;
    if (law == Law::in_surface) REQUIRE(answer.is_parallel);
    if (law == Law::exact_border && !answer.is_parallel) REQUIRE(answer.on_edge);
    const Vec d(ray.direction), o(ray.origin), p[3] = {Vec(shape.p0) - o, Vec(shape.p1) - o, Vec(shape.p2) - o};
    const Q side[3] = {dot(d, cross(p[1], p[2])), dot(d, cross(p[2], p[0])), dot(d, cross(p[0], p[1]))};
    const int orientation = sign(Q(side[0] + side[1] + side[2]));
    REQUIRE(answer.is_parallel == (orientation == 0));
    if (answer.is_parallel) return;
    bool is_inside = true;
    for (std::size_t i = 0; i < 3; ++i) {
      REQUIRE(answer.edge_sign[i] == sign(side[i]) * orientation);
      is_inside = is_inside && sign(side[i]) * orientation >= 0;
    }
    // The weighted vertices must meet the ray at the same t.
    const Q t = (side[0] * dot(p[0], d) + side[1] * dot(p[1], d) + side[2] * dot(p[2], d)) /
                ((side[0] + side[1] + side[2]) * dot(d, d));
    require_same(to_exact(t), answer.t);
    REQUIRE(answer.hit == (is_inside && is_within(ray, t)));
  });
  CHECK(hits > 1000);
  CHECK(misses > 300);
  CHECK(edges > 300);
  CHECK(vertices > 100);
}

TEST_CASE("parallelogram: both paths agree, it is the union of its two triangles") {
  int hits = 0, misses = 0;
  over_all_laws(parallelogram_case, [&](const Ray& ray, const Parallelogram& shape, Law law) {
    const PlanarAnswer answer = parallelogram(ray, shape);
    require_same(answer, parallelogram(ray, shape, Arithmetic::rational));
    ++(answer.hit ? hits : misses);
    if (law == Law::exact_border && !answer.is_parallel) REQUIRE(answer.on_edge);
    // Only where the corners are doubles themselves, as on the lattices.
    if (law != Law::exact_border && law != Law::in_surface) return;
    const auto corner = [&](double a, double b) {
      const auto at = [&](double c, double u, double v) { return c + a * u + b * v; };
      return strahl::Vec3{at(shape.corner.x, shape.edge_u.x, shape.edge_v.x),
                          at(shape.corner.y, shape.edge_u.y, shape.edge_v.y),
                          at(shape.corner.z, shape.edge_u.z, shape.edge_v.z)};
    };
    const PlanarAnswer low = triangle(ray, {corner(0, 0), corner(1, 0), corner(0, 1)});
    const PlanarAnswer high = triangle(ray, {corner(1, 1), corner(0, 1), corner(1, 0)});
    REQUIRE(answer.hit == (low.hit || high.hit));
    if (answer.hit) require_same(answer.t, low.hit ? low.t : high.t);
  });
  CHECK(hits > 1000);
  CHECK(misses > 300);
}

TEST_CASE("disk: both paths agree with the point's own distance from the centre") {
  int hits = 0, misses = 0;
  over_all_laws(disk_case, [&](const Ray& ray, const Disk& shape, Law law) {
    const Answer answer = disk(ray, shape);
    require_same(answer, disk(ray, shape, Arithmetic::rational));
    ++(answer.hit ? hits : misses);
    const Vec n = cross(Vec(shape.axis_u), Vec(shape.axis_v)), d(ray.direction);
    if (dot(n, d) == 0) {
      REQUIRE_FALSE(answer.hit);
      return;
    }
    if (law == Law::exact_border) REQUIRE(answer.margin == 0);
    const Q t = dot(n, Vec(shape.center) - Vec(ray.origin)) / dot(n, d);
    const Vec p = point_at(ray, t) - Vec(shape.center);
    REQUIRE(answer.hit == (dot(p, p) <= Q(shape.radius) * Q(shape.radius) && is_within(ray, t)));
  });
  CHECK(hits > 1000);
  CHECK(misses > 300);
}

TEST_CASE("box: both paths agree with trying all six faces") {
  int hits = 0, misses = 0;
  over_all_laws(aabb_case, [&](const Ray& ray, const Aabb& box, Law) {
    const AabbAnswer answer = aabb(ray, box), rational = aabb(ray, box, Arithmetic::rational);
    require_same(answer, rational);
    REQUIRE(answer.overlaps == rational.overlaps);
    ++(answer.hit ? hits : misses);
    const auto list = [](const Vec& v) { return std::array{v.x, v.y, v.z}; };
    const auto o = list(Vec(ray.origin)), d = list(Vec(ray.direction)), low = list(Vec(box.min)),
               high = list(Vec(box.max));
    bool is_met = false;
    Q nearest;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (d[axis] == 0) continue;
      for (const Q& face : {low[axis], high[axis]}) {
        const Q t = (face - o[axis]) / d[axis];
        if (!is_within(ray, t) || (is_met && t >= nearest)) continue;
        bool is_on_box = true;
        for (std::size_t other = 0; other < 3; ++other) {
          const Q x = o[other] + t * d[other];
          is_on_box = is_on_box && x >= low[other] && x <= high[other];
        }
        if (is_on_box) is_met = true, nearest = t;
      }
    }
    REQUIRE(answer.hit == is_met);
    if (is_met) require_same(answer.t, to_exact(nearest));
  });
  CHECK(hits > 1000);
  CHECK(misses > 300);
}
