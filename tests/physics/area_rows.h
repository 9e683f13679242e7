// SPDX-License-Identifier: MIT
// The rows of the tests of lights and areas, one for every entry of cl/areas/areas.def. A new entry needs only a row
// here.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "scene/model/scene.h"

namespace strahl::test {

struct AreaRow {
  std::string entry;  ///< Of areas.def.
  Geometry geometry;
  bool is_flipped;
  double area;
  /// The points from which it is seen. Only its own back may hide a drawn place.
  std::vector<Vec3> froms;
  /// The distance of a point from the surface, and the normal there on the side that emits.
  std::function<double(const Vec3&)> off;
  std::function<Vec3(const Vec3&)> normal;
  /// Maps a place, as seen from a point, to a square over which places are distributed uniformly.
  std::function<std::array<double, 2>(const Vec3& from, const Vec3& place)> chart;
  /// The solid angle of the emitting side, seen from a point.
  std::function<double(const Vec3& from)> solid_angle;
  /// True: places are drawn uniformly over the solid angle; false: over the area.
  std::function<bool(const Vec3& from)> is_by_angle = [](const Vec3&) { return false; };
};

/// A. Van Oosterom, J. Strackee, "The Solid Angle of a Plane Triangle", 1983.
inline double triangle_angle(const Vec3& from, const Vec3& p, const Vec3& q, const Vec3& r) {
  const Vec3 a = p - from, b = q - from, c = r - from;
  const double la = length(a), lb = length(b), lc = length(c);
  return std::fabs(2 *
                   std::atan2(dot(a, cross(b, c)), la * lb * lc + dot(a, b) * lc + dot(a, c) * lb + dot(b, c) * la));
}

/// The share of a turn, within [0, 1), of the angle from x to y.
inline double turn_of(double x, double y) {
  const double turn = std::atan2(y, x) / (2 * std::numbers::pi);
  return turn < 0 ? turn + 1 : turn;
}

/// Weights a, b of p = corner + a u + b v.
inline std::array<double, 2> weights_of(const Vec3& p, const Vec3& u, const Vec3& v) {
  const double uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), pu = dot(p, u), pv = dot(p, v);
  const double whole = uu * vv - uv * uv;
  return {(pu * vv - pv * uv) / whole, (pv * uu - pu * uv) / whole};
}

inline AreaRow triangle_row() {
  const Vec3 p{1, 0, 0}, u{2, 0, 0.5}, v{0.25, 1.5, 0};
  const Vec3 n = normalized(cross(u, v));
  return {"triangle",
          Triangle{p, p + u, p + v},
          false,
          0.5 * length(cross(u, v)),
          {{1.5, 0.5, 3}, {1.75, 0.5, 0.5}, {40, -30, 100}},
          [=](const Vec3& x) { return std::fabs(dot(x - p, n)); },
          [=](const Vec3&) { return n; },
          [=](const Vec3&, const Vec3& x) {
            // The strip beyond a has a share of (1 - a)^2.
            const auto [a, b] = weights_of(x - p, u, v);
            return std::array{(1 - a) * (1 - a), b / (1 - a)};
          },
          [=](const Vec3& from) { return triangle_angle(from, p, p + u, p + v); }};
}

inline AreaRow parallelogram_row() {
  const Vec3 p{-1, -1, 2}, u{2, 0.5, 0}, v{0, 1, 0.5};
  const Vec3 n = normalized(cross(u, v));
  return {"parallelogram",
          Rectangle{p, u, v},
          true,
          length(cross(u, v)),
          {{0, 0, -1}, {0.25, 0, 1.75}, {-200, 0, -300}},
          [=](const Vec3& x) { return std::fabs(dot(x - p, n)); },
          [=](const Vec3&) { return -1 * n; },
          [=](const Vec3&, const Vec3& x) { return weights_of(x - p, u, v); },
          [=](const Vec3& from) {
            return triangle_angle(from, p, p + u, p + u + v) + triangle_angle(from, p, p + u + v, p + v);
          }};
}

/// Seen from points on its axis.
inline AreaRow disk_row() {
  const Vec3 centre{0.5, 0.25, 0}, u{0, 0, 2}, v{2, 0, 0}, n{0, 1, 0};
  return {"disk",
          Disk{centre, u, v},
          false,
          4 * std::numbers::pi,
          {{0.5, 2, 0}, {0.5, 0.5, 0}, {0.5, 500, 0}},
          [=](const Vec3& x) { return std::max(std::fabs(dot(x - centre, n)), length(x - centre) - 2); },
          [=](const Vec3&) { return n; },
          [=](const Vec3&, const Vec3& x) {
            const Vec3 d = x - centre;
            return std::array{dot(d, d) / 4, turn_of(dot(d, u), dot(d, v))};
          },
          [=](const Vec3& from) {
            const double away = length(from - centre);
            return 2 * std::numbers::pi * 4 / (std::hypot(away, 2) * (std::hypot(away, 2) + away));
          }};
}

inline AreaRow sphere_row(bool is_flipped, const std::vector<Vec3>& froms) {
  const Vec3 centre{0.5, -1, 2};
  const double radius = 1.5;
  Sphere sphere;
  sphere.center = centre;
  sphere.radius = radius;
  const auto sine_at = [=](const Vec3& from) { return radius / length(from - centre); };
  // 1 - cos of half the cone that it fills.
  const auto less_at = [=](const Vec3& from) {
    const double s = sine_at(from);
    return s * s / (1 + std::sqrt((1 - s) * (1 + s)));
  };
  return {
      "sphere",
      sphere,
      is_flipped,
      4 * std::numbers::pi * radius * radius,
      froms,
      [=](const Vec3& x) { return std::fabs(length(x - centre) - radius); },
      [=](const Vec3& x) { return (is_flipped ? -1 : 1) * normalized(x - centre); },
      [=](const Vec3& from, const Vec3& x) {
        if (sine_at(from) >= 1)
          return std::array{0.5 + 0.5 * (x.z - centre.z) / radius, turn_of(x.x - centre.x, x.y - centre.y)};
        const Vec3 axis = normalized(centre - from), towards = normalized(x - from);
        const auto [across, along] = orthonormal_basis(axis);
        // 1 - cos from the chord: nothing cancels at a large distance.
        const Vec3 chord = towards - axis;
        return std::array{0.5 * dot(chord, chord) / less_at(from), turn_of(dot(towards, across), dot(towards, along))};
      },
      [=](const Vec3& from) { return sine_at(from) < 1 ? 2 * std::numbers::pi * less_at(from) : 4 * std::numbers::pi; },
      [=](const Vec3& from) { return sine_at(from) < 1; }};
}

/// Emits inwards; seen from the middle of its axis.
inline AreaRow cylinder_row() {
  const Vec3 foot{0, 0, -1}, axis{0, 0, 4};
  const double radius = 1.25;
  return {
      "cylinder",
      Cylinder{foot, foot + axis, radius, {1, 0, 0}},
      true,
      2 * std::numbers::pi * radius * 4,
      {{0, 0, 1}},
      [=](const Vec3& x) { return std::max(std::fabs(std::hypot(x.x, x.y) - radius), std::max(-1 - x.z, x.z - 3)); },
      [=](const Vec3& x) {
        return -1 * normalized(Vec3{x.x, x.y, 0});
      },
      [=](const Vec3&, const Vec3& x) {
        return std::array{turn_of(x.x, x.y), (x.z + 1) / 4};
      },
      [=](const Vec3&) { return 4 * std::numbers::pi * 2 / std::hypot(2, radius); }};
}

inline std::vector<AreaRow> area_rows() {
  return {triangle_row(), parallelogram_row(), disk_row(),
          sphere_row(false, {{0.5, -1, 5}, {2.25, -1, 2}, {700, -400, 100}}),
          // From its middle and elsewhere within.
          sphere_row(true, {{0.5, -1, 2}, {0.5, -0.5, 1.5}}), cylinder_row()};
}

/// The area alone in a scene, as a shape; radiance 2, 1, 1/2.
inline Shape emitting_shape(const AreaRow& row) {
  Shape shape;
  shape.geometry = row.geometry;
  shape.flip_normals = row.is_flipped;
  shape.radiance = Rgb{2, 1, 0.5};
  return shape;
}

}  // namespace strahl::test
