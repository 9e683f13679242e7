// SPDX-License-Identifier: MIT
// One class a kind of shape, for tests that run over all of them: how to draw a case, what stands in the scene, what
// the device holds of it once packed (the oracle is asked about that, so packing's own rounding does not count), and
// how far an error of one last place in what the shape computes from can move t and the border.
#pragma once

#include <cmath>
#include <initializer_list>
#include <span>

#include "oracle/generators.h"
#include "scene/model/scene.h"

namespace strahl::test {

using oracle::Law;
using oracle::Random;
using oracle::Rounding;

inline double distance(const Vec3& a, const Vec3& b) { return length(a - b); }

template <class Real>
Vec3 point_at(std::span<const Real> planes, std::size_t at) {
  return {static_cast<double>(planes[at]), static_cast<double>(planes[at + 1]), static_cast<double>(planes[at + 2])};
}

/// Of the angle at which the ray's origin sees p beside the ray; 1 where p is the origin.
inline double sine_to(const oracle::Ray& ray, const Vec3& p) {
  const Vec3 to = p - ray.origin;
  return length(to) > 0 ? length(cross(normalized(to), normalized(ray.direction))) : 1;
}

/// Where along the ray's largest axis the vertices lie, in t; a hit of a flat shape cannot lie outside.
struct Extent {
  double low = INFINITY, high = -INFINITY;

  Extent(const oracle::Ray& ray, std::initializer_list<Vec3> vertices) {
    const Vec3 &o = ray.origin, &d = ray.direction;
    const double x = std::fabs(d.x), y = std::fabs(d.y), z = std::fabs(d.z);
    for (const Vec3& v : vertices) {
      // The kernels' choice among equals: z before y before x.
      const double t = x > y && x > z ? (v.x - o.x) / d.x : y > z && !(x > y) ? (v.y - o.y) / d.y : (v.z - o.z) / d.z;
      low = std::fmin(low, t);
      high = std::fmax(high, t);
    }
  }
};

/// Each has: kind, the entry of shapes.def; draw; geometry, for the scene; asked, the packed planes as the oracle's
/// shape; answer. And, of the oracle's answer for the whole line:
///   scale   the distances that differences are taken over, world units
///   cosine  of ray and normal where the line meets the shape: t |d| moves by error * scale / cosine
///   band    the oracle's margin moves by error * band
struct SphereCases {
  static constexpr const char* kind = "sphere";
  using Shape = oracle::Sphere;
  static oracle::Case<Shape> draw(Random& r, Law law, Rounding to) { return oracle::sphere_case(r, law, to); }
  static Geometry geometry(const Shape& s) {
    Sphere sphere;
    sphere.center = s.center;
    sphere.radius = s.radius;
    return sphere;
  }
  template <class Real>
  static Shape asked(std::span<const Real> p) {
    return {point_at(p, 0), static_cast<double>(p[3])};
  }
  static oracle::QuadricAnswer answer(const oracle::Ray& ray, const Shape& s) { return oracle::sphere(ray, s); }
  static double scale(const oracle::Ray& ray, const Shape& s, const oracle::Answer&) {
    return distance(ray.origin, s.center) + s.radius;
  }
  static double cosine(const oracle::Ray&, const Shape&, const oracle::Answer& a) {
    return std::sqrt(std::fabs(a.margin));
  }
  static double band(const oracle::Ray& ray, const Shape& s, const oracle::Answer& a) {
    return scale(ray, s, a) / s.radius;
  }
};

struct CylinderCases {
  static constexpr const char* kind = "cylinder";
  using Shape = oracle::Cylinder;
  static oracle::Case<Shape> draw(Random& r, Law law, Rounding to) { return oracle::cylinder_case(r, law, to); }
  static Geometry geometry(const Shape& s) {
    const Vec3 p1 = s.p0 + s.axis, axis = p1 - s.p0;
    return Cylinder{s.p0, p1, s.radius, orthonormal_basis(normalized(length(axis) > 0 ? axis : s.axis))[0]};
  }
  template <class Real>
  static Shape asked(std::span<const Real> p) {
    return {point_at(p, 0), static_cast<double>(p[6]) * point_at(p, 3), static_cast<double>(p[7])};
  }
  static oracle::QuadricAnswer answer(const oracle::Ray& ray, const Shape& s) { return oracle::cylinder(ray, s); }
  static double scale(const oracle::Ray& ray, const Shape& s, const oracle::Answer&) {
    return distance(ray.origin, s.p0) + length(s.axis) + s.radius;
  }
  /// Across the axis as for a circle, times the sine of ray and axis.
  static double cosine(const oracle::Ray& ray, const Shape& s, const oracle::Answer&) {
    const double sine = sine_to_axis(ray, s);
    if (sine == 0) return 0;
    const Vec3 across = (1 / sine) * cross(normalized(ray.direction), normalized(s.axis));
    const double away = dot(ray.origin - s.p0, across) / s.radius;
    return std::sqrt(std::fabs(1 - away * away)) * sine;
  }
  /// At the silhouette or at an end.
  static double band(const oracle::Ray& ray, const Shape& s, const oracle::Answer& a) {
    return scale(ray, s, a) *
           std::fmax(1 / (s.radius * sine_to_axis(ray, s)), 1 / (length(s.axis) * cosine(ray, s, a)));
  }
  static double sine_to_axis(const oracle::Ray& ray, const Shape& s) {
    return length(cross(normalized(ray.direction), normalized(s.axis)));
  }
};

struct PlaneCases {
  static constexpr const char* kind = "plane";
  using Shape = oracle::Plane;
  static oracle::Case<Shape> draw(Random& r, Law law, Rounding to) { return oracle::plane_case(r, law, to); }
  static Geometry geometry(const Shape& s) {
    const auto [u, v] = orthonormal_basis(normalized(s.normal));
    return Plane{s.point, s.normal, u, v};
  }
  template <class Real>
  static Shape asked(std::span<const Real> p) {
    return {point_at(p, 0), point_at(p, 3)};
  }
  static oracle::Answer answer(const oracle::Ray& ray, const Shape& s) { return oracle::plane(ray, s); }
  static double scale(const oracle::Ray& ray, const Shape& s, const oracle::Answer& a) {
    return distance(ray.origin, s.point) + std::fabs(a.t.value) * length(ray.direction);
  }
  static double cosine(const oracle::Ray&, const Shape&, const oracle::Answer& a) { return a.margin; }
  static double band(const oracle::Ray&, const Shape&, const oracle::Answer&) { return 0; }
};

struct DiskCases {
  static constexpr const char* kind = "disk";
  using Shape = oracle::Disk;
  static oracle::Case<Shape> draw(Random& r, Law law, Rounding to) { return oracle::disk_case(r, law, to); }
  static Geometry geometry(const Shape& s) { return Disk{s.center, s.axis_u, s.axis_v}; }
  /// Axes that span the packed normal's plane exactly: their cross product is a multiple of it.
  template <class Real>
  static Shape asked(std::span<const Real> p) {
    const Vec3 n = point_at(p, 3);
    const double x = std::fabs(n.x), y = std::fabs(n.y), z = std::fabs(n.z);
    Shape s{point_at(p, 0), {n.y, -n.x, 0}, {n.z, 0, -n.x}, std::sqrt(static_cast<double>(p[6]))};
    if (y > x && y >= z) s.axis_u = {0, n.z, -n.y}, s.axis_v = {-n.y, n.x, 0};
    if (z > x && z > y) s.axis_u = {-n.z, 0, n.x}, s.axis_v = {0, -n.z, n.y};
    return s;
  }
  static oracle::Answer answer(const oracle::Ray& ray, const Shape& s) { return oracle::disk(ray, s); }
  static double scale(const oracle::Ray& ray, const Shape& s, const oracle::Answer&) {
    return distance(ray.origin, s.center) + s.radius;
  }
  static double cosine(const oracle::Ray& ray, const Shape& s, const oracle::Answer&) {
    return std::fabs(dot(normalized(ray.direction), normalized(cross(s.axis_u, s.axis_v))));
  }
  static double band(const oracle::Ray& ray, const Shape& s, const oracle::Answer& a) {
    return scale(ray, s, a) / (s.radius * cosine(ray, s, a));
  }
};

struct TriangleCases {
  static Extent extent(const oracle::Ray& ray, const oracle::Triangle& s) { return {ray, {s.p0, s.p1, s.p2}}; }
  static constexpr const char* kind = "triangle";
  using Shape = oracle::Triangle;
  static oracle::Case<Shape> draw(Random& r, Law law, Rounding to) { return oracle::triangle_case(r, law, to); }
  static Geometry geometry(const Shape& s) { return Triangle{s.p0, s.p1, s.p2}; }
  template <class Real>
  static Shape asked(std::span<const Real> p) {
    return {point_at(p, 0), point_at(p, 3), point_at(p, 6)};
  }
  static oracle::PlanarAnswer answer(const oracle::Ray& ray, const Shape& s) { return oracle::triangle(ray, s); }
  static double scale(const oracle::Ray& ray, const Shape& s, const oracle::Answer&) {
    return std::fmax(distance(ray.origin, s.p0), std::fmax(distance(ray.origin, s.p1), distance(ray.origin, s.p2)));
  }
  static double cosine(const oracle::Ray&, const Shape&, const oracle::PlanarAnswer& a) { return a.cosine; }
  static double band(const oracle::Ray& ray, const Shape& s, const oracle::Answer&) {
    return std::fmax(sine_to(ray, s.p0), std::fmax(sine_to(ray, s.p1), sine_to(ray, s.p2)));
  }
};

/// Sides from the packed corners; the fourth corner was rounded by itself, so it is off by an input error.
struct ParallelogramCases {
  static constexpr const char* kind = "parallelogram";
  using Shape = oracle::Parallelogram;
  static oracle::Case<Shape> draw(Random& r, Law law, Rounding to) { return oracle::parallelogram_case(r, law, to); }
  static Geometry geometry(const Shape& s) { return Rectangle{s.corner, s.edge_u, s.edge_v}; }
  template <class Real>
  static Shape asked(std::span<const Real> p) {
    return {point_at(p, 0), point_at(p, 3) - point_at(p, 0), point_at(p, 9) - point_at(p, 0)};
  }
  static oracle::PlanarAnswer answer(const oracle::Ray& ray, const Shape& s) { return oracle::parallelogram(ray, s); }
  static double scale(const oracle::Ray& ray, const Shape& s, const oracle::Answer&) {
    return distance(ray.origin, s.corner) + length(s.edge_u) + length(s.edge_v);
  }
  static double cosine(const oracle::Ray&, const Shape&, const oracle::PlanarAnswer& a) { return a.cosine; }
  static double band(const oracle::Ray& ray, const Shape& s, const oracle::Answer&) {
    const Vec3 b = s.corner + s.edge_u, c = b + s.edge_v, d = s.corner + s.edge_v;
    const double rounded = length(s.corner) + length(s.edge_u) + length(s.edge_v);
    return std::fmax(std::fmax(sine_to(ray, s.corner), sine_to(ray, b)),
                     std::fmax(sine_to(ray, c) + rounded / distance(ray.origin, c), sine_to(ray, d)));
  }
};

struct BoxCases {
  static constexpr const char* kind = "box";
  using Shape = oracle::Aabb;
  static oracle::Case<Shape> draw(Random& r, Law law, Rounding to) { return oracle::aabb_case(r, law, to); }
  static Geometry geometry(const Shape& s) { return Box{s.min, s.max}; }
  template <class Real>
  static Shape asked(std::span<const Real> p) {
    const auto at = [&](std::size_t i) { return static_cast<double>(p[i]); };
    return {{at(0), at(2), at(4)}, {at(1), at(3), at(5)}};
  }
  static oracle::AabbAnswer answer(const oracle::Ray& ray, const Shape& s) { return oracle::aabb(ray, s); }
};

}  // namespace strahl::test
