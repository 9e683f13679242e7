// SPDX-License-Identifier: MIT
// Exact answers to "where does this ray meet this shape", independent of the device code. Inputs are doubles (a float
// is one) and taken at face value: every decision is the sign of a polynomial in them, settled in binary128 with an
// error bound or, where that cannot tell, in GMP rationals; distances come from the same arithmetic or from MPFR (200
// bits).
//
// Conventions: t in units of the direction's length, which may be any; t_min <= t <= t_max inclusive; borders belong to
// the shape; a zero direction meets nothing. Coordinates must be finite, the two bounds of t may be infinite.
#pragma once

#include <array>
#include <limits>

#include "oracle/exact.h"
#include "scene/model/vec.h"

namespace strahl::oracle {

/// filtered is the fast default; rational skips the filter (the tests hold the two against each other).
enum class Arithmetic { filtered, rational };

struct Ray {
  Vec3 origin, direction;
  double t_min = 0;
  double t_max = std::numeric_limits<double>::infinity();
};

struct Answer {
  /// The shape is met at some t of the range.
  bool hit = false;
  /// The nearest such t; defined where hit.
  Exact t;
  /// By how much the ray's whole line meets (> 0) or misses (< 0) the shape, as a relative quantity named with each
  /// function; 0 exactly on the border. Tests leave a declared band |margin| < k u out.
  double margin = -std::numeric_limits<double>::infinity();
  /// Smallest relative distance of a crossing of the line from t_min or t_max.
  double range_margin = std::numeric_limits<double>::infinity();
};

struct Sphere {
  Vec3 center;
  double radius = 1;
};

struct QuadricAnswer : Answer {
  /// Sign of the discriminant: the line crosses twice, touches, or misses. A cylinder's is the infinite cylinder's.
  int discriminant_sign = -1;
  /// Both roots, root[0] <= root[1]; defined where discriminant_sign >= 0.
  std::array<Exact, 2> root;
  /// Which of the roots lie on the shape (a cylinder's end between its ends only).
  std::array<bool, 2> on_shape{false, false};
};

/// margin = 1 - (L / r)^2 with L the distance of the line from the centre. Radius 0 is never met.
[[nodiscard]] QuadricAnswer sphere(const Ray&, const Sphere&, Arithmetic = Arithmetic::filtered);

struct Plane {
  Vec3 point, normal;  ///< the normal may have any length
};

/// margin = |cos| of the angle between ray and normal, so it never is negative; a parallel ray misses, also within.
[[nodiscard]] Answer plane(const Ray&, const Plane&, Arithmetic = Arithmetic::filtered);

struct Aabb {
  Vec3 min, max;  ///< closed; flat and point boxes are boxes, an inverted one is empty
};

struct AabbAnswer : Answer {
  bool line_meets = false;
  /// Entry and exit of the line; infinite in no direction but a zero one. Defined where line_meets.
  Exact entry, exit;
  /// Axis (0, 1, 2) of the entry and exit face, the lowest of equals.
  int entry_axis = 0, exit_axis = 0;
  /// [entry, exit] and [t_min, t_max] share a point: what a traversal asks, while hit asks for the surface.
  bool overlaps = false;
};

/// hit: the entry, or the exit where the entry lies before t_min. margin = (exit - entry) / max(|entry|, |exit|).
[[nodiscard]] AabbAnswer aabb(const Ray&, const Aabb&, Arithmetic = Arithmetic::filtered);

struct Triangle {
  Vec3 p0, p1, p2;
};

struct PlanarAnswer : Answer {
  /// Coordinates along edge_u and edge_v (barycentric weights of p1 and p2), rounded; defined unless parallel.
  double u = 0, v = 0;
  /// |cos| of the angle between ray and normal; 0 exactly where the ray is parallel or the shape has no area.
  double cosine = 0;
  bool is_parallel = true;
  /// The line meets the closed shape on its border; at a vertex both are set.
  bool on_edge = false, on_vertex = false;
  /// Sign of the line's side of each edge, 1 inside, whatever the orientation. Triangle: opposite p0, p1, p2.
  /// Parallelogram: u >= 0, u <= 1, v >= 0, v <= 1.
  std::array<int, 4> edge_sign{0, 0, 0, 1};
};

/// Closed, from both sides. In-plane rays and triangles without area are never met.
/// margin = smallest over the edges (a, b) of d . ((a - o) x (b - o)) / (|d| |a - o| |b - o|), positive inside: the
/// relative size of the cancelled edge function, 0 where parallel.
[[nodiscard]] PlanarAnswer triangle(const Ray&, const Triangle&, Arithmetic = Arithmetic::filtered);

struct Parallelogram {
  Vec3 corner, edge_u, edge_v;
};

/// corner + u edge_u + v edge_v with u, v in [0, 1]; everything else as for the triangle.
[[nodiscard]] PlanarAnswer parallelogram(const Ray&, const Parallelogram&, Arithmetic = Arithmetic::filtered);

struct Disk {
  Vec3 center, axis_u, axis_v;  ///< span the plane; rounded axes need be neither quite perpendicular nor equally long
  double radius = 1;
};

/// |p - center| <= radius in the plane through center with the normal axis_u x axis_v. margin = 1 - (|p - c| / r)^2;
/// -infinity where parallel.
[[nodiscard]] Answer disk(const Ray&, const Disk&, Arithmetic = Arithmetic::filtered);

struct Cylinder {
  Vec3 p0, axis;  ///< from the centre of one end to that of the other
  double radius = 1;
};

/// The open mantle (no caps), from both sides; a ray parallel to the axis misses, also within the mantle.
/// margin = the smallest in absolute value of 1 - (L / r)^2 for the infinite cylinder (L: distance of line and axis)
/// and, per root, its place along the axis (0 to 1) measured from the nearer end, positive within; its sign tells
/// whether some root lies on the mantle.
[[nodiscard]] QuadricAnswer cylinder(const Ray&, const Cylinder&, Arithmetic = Arithmetic::filtered);

}  // namespace strahl::oracle
