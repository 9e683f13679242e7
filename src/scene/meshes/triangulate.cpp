// SPDX-License-Identifier: MIT
// Ear clipping (G. H. Meisters, "Polygons Have Ears", American Mathematical Monthly 82, 1975) in the plane of the
// polygon: the coordinate that the Newell normal points along most is dropped, which rounds nothing. All turns are
// decided exactly (J. R. Shewchuk, "Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric
// Predicates", Discrete & Computational Geometry 18, 1997), so a triangle is degenerate where its area is exactly 0.
// Ears are closed: a vertex on the cut blocks it, which keeps collinear corners. Vertices that coincide with a corner
// of the ear do not block it (D. Eberly, "Triangulation by Ear Clipping", 2002), which opens keyholes.
// Weak: a sliver of four and more corners thinner than 1e-15 of its length may be taken for degenerate. O(n^2).
#include "scene/meshes/triangulate.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "scene/meshes/number_set.h"
#include "scene/meshes/point_grid.h"

namespace strahl {
namespace {

/// Sum of 12 doubles with the exact sign: the terms grow an expansion whose components do not overlap.
int exact_sign(std::array<double, 12> terms) {
  std::array<double, 12> expansion{};
  int size = 0;
  for (double term : terms) {
    for (int i = 0; i < size; ++i) {
      double& component = expansion[static_cast<std::size_t>(i)];
      const double sum = term + component;
      const double part = sum - term;
      component = (term - (sum - part)) + (component - part);
      term = sum;
    }
    expansion[static_cast<std::size_t>(size++)] = term;
  }
  for (int i = size - 1; i >= 0; --i) {
    const double component = expansion[static_cast<std::size_t>(i)];
    if (component != 0) return component > 0 ? 1 : -1;
  }
  return 0;
}

/// Sign of the area of (a, b, c): 1 for a left turn. Exact while no product underflows.
int turn(const Vec2& a, const Vec2& b, const Vec2& c) {
  const double left = (a.x - c.x) * (b.y - c.y);
  const double right = (a.y - c.y) * (b.x - c.x);
  const double det = left - right;
  constexpr double unit = std::numeric_limits<double>::epsilon() / 2;
  constexpr double bound = (3 + 16 * unit) * unit;  // Shewchuk's ccwerrboundA
  if (std::abs(det) > bound * (std::abs(left) + std::abs(right))) return det > 0 ? 1 : -1;
  std::array<double, 12> terms{};
  std::size_t n = 0;
  const auto add = [&](double p, double q) {
    terms[n++] = p * q;
    terms[n] = std::fma(p, q, -terms[n - 1]);
    ++n;
  };
  add(a.x, b.y), add(-a.x, c.y), add(-c.x, b.y);
  add(-a.y, b.x), add(a.y, c.x), add(c.y, b.x);
  return exact_sign(terms);
}

/// Goes round the polygon from corner 1 and clips the ears that it meets. In a simple polygon a corner that is no ear
/// stays none until a neighbour is clipped, since the corner of its triangle that lies deepest is reflex and stays; so
/// each clip has two corners tried anew. Where a polygon touches itself that need not hold: all others are tried once
/// more before it is given up.
class EarClipper {
 public:
  EarClipper(const std::vector<Vec2>& points, const std::vector<int>& names)
      : points_(points), names_(names), untried_(points.size()) {
    const int n = static_cast<int>(points.size());
    for (int i = 0; i < n; ++i) {
      previous_.push_back((i + n - 1) % n);
      next_.push_back((i + 1) % n);
      untried_.add(at(i));
    }
    std::vector<int> blockers;
    for (int i = 0; i < n; ++i) {
      turn_.push_back(turn_at(i));
      is_listed_.push_back(turn_.back() <= 0);
      if (is_listed_.back()) blockers.push_back(i);
    }
    grid_.emplace(points, blockers);
    is_clipped_.assign(points.size(), false);
  }

  bool clip(std::vector<std::array<int, 3>>& triangles) {
    const std::size_t none = points_.size();
    std::size_t left = points_.size();
    int retries = most_retries;
    bool is_retry = true;  // All corners that are left have been tried since the last clip.
    for (std::size_t from = 1; left > 2;) {
      const std::size_t found = untried_.next(from);
      if (found == none) {
        // No ear is left: the polygon crosses itself or the rest has no area.
        if (is_retry || retries-- == 0) return false;
        is_retry = true;
        for (std::size_t i = 0; i < none; ++i)
          if (!is_clipped_[i]) untried_.add(i);
        continue;
      }
      const int apex = static_cast<int>(found);
      untried_.remove(found);
      if (!is_ear(apex)) continue;
      const int a = previous_[found], c = next_[found];
      triangles.push_back({names_[at(a)], names_[found], names_[at(c)]});
      next_[at(a)] = c;
      previous_[at(c)] = a;
      is_clipped_[found] = true;
      for (const int i : {a, c}) {
        turn_[at(i)] = turn_at(i);
        if (turn_[at(i)] <= 0 && !is_listed_[at(i)]) {
          is_listed_[at(i)] = true;
          late_blockers_.push_back(i);
        }
        untried_.add(at(i));
      }
      is_retry = false;
      from = at(c);
      --left;
    }
    return true;
  }

 private:
  static constexpr int most_retries = 64;  // Each looks at all corners, which keeps the whole in O(n^2).

  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  const Vec2& point(int i) const { return points_[at(i)]; }
  int turn_at(int i) const { return turn(point(previous_[at(i)]), point(i), point(next_[at(i)])); }

  bool is_ear(int i) const {
    if (turn_[at(i)] <= 0) return false;
    const Vec2 &a = point(previous_[at(i)]), &b = point(i), &c = point(next_[at(i)]);
    const Vec2 low{std::min({a.x, b.x, c.x}), std::min({a.y, b.y, c.y})};
    const Vec2 high{std::max({a.x, b.x, c.x}), std::max({a.y, b.y, c.y})};
    // Only reflex and flat vertices can lie inside an ear.
    const auto blocks = [&](int k) {
      const Vec2& p = point(k);
      if (turn_[at(k)] > 0 || is_clipped_[at(k)]) return false;
      if (p.x < low.x || p.x > high.x || p.y < low.y || p.y > high.y) return false;
      if (p == a || p == b || p == c) return false;
      return turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
    };
    return !grid_->any_in(low, high, blocks) && std::ranges::none_of(late_blockers_, blocks);
  }

  const std::vector<Vec2>& points_;
  const std::vector<int>& names_;
  std::optional<PointGrid> grid_;   ///< Of the corners that were reflex or flat at first,
  std::vector<int> late_blockers_;  ///< and those that became so: of polygons that cross themselves alone.
  NumberSet untried_;               ///< Since a neighbour was clipped.
  std::vector<int> previous_, next_, turn_;
  std::vector<bool> is_clipped_, is_listed_;
};

/// A power of two that brings the largest coordinate near 1, so that products neither overflow nor vanish.
double exact_scale(std::span<const Vec3> polygon) {
  double largest = 0;
  for (const Vec3& p : polygon) largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  return largest > 0 ? std::ldexp(1.0, std::clamp(-std::ilogb(largest), -1022, 1022)) : 1.0;
}

enum class Drop { x, y, z };

Vec2 flatten(const Vec3& p, Drop drop) {
  if (drop == Drop::x) return {p.y, p.z};
  if (drop == Drop::y) return {p.z, p.x};
  return {p.x, p.y};
}

bool triangle_has_area(std::span<const Vec3> p) {
  const Vec3 normal = cross(p[1] - p[0], p[2] - p[0]);
  const double size = std::max({std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)});
  const double edge = std::max(dot(p[1] - p[0], p[1] - p[0]), dot(p[2] - p[0], p[2] - p[0]));
  const double far = std::max(dot(p[0], p[0]), edge);
  // Differences err by an ulp of the coordinates, products of the edges by an ulp: 1e-14 leaves a factor of ten.
  if (far < 1e100 && edge > 1e-100 && size > 1e-14 * std::sqrt(far * edge)) return true;
  const double scale = exact_scale(p);
  return std::ranges::any_of(std::array{Drop::x, Drop::y, Drop::z}, [&](Drop drop) {
    return turn(flatten(scale * p[0], drop), flatten(scale * p[1], drop), flatten(scale * p[2], drop)) != 0;
  });
}

/// The polygon (scaled, of area) in its plane, turning left.
void flatten_all(std::span<const Vec3> corners, std::span<Vec2> points) {
  Vec3 normal;
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    normal = normal + cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
  }
  const double x = std::abs(normal.x), y = std::abs(normal.y), z = std::abs(normal.z);
  const Drop drop = x >= y && x >= z ? Drop::x : (y >= z ? Drop::y : Drop::z);
  const bool mirrored = (drop == Drop::x ? normal.x : drop == Drop::y ? normal.y : normal.z) < 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2 p = flatten(corners[i], drop);
    points[i] = mirrored ? Vec2{p.y, p.x} : p;
  }
}

/// Four left turns make one round: no ears need be looked for.
bool is_convex(std::span<const Vec3, 4> quad) {
  const double scale = exact_scale(quad);
  const std::array corners{scale * quad[0], scale * quad[1], scale * quad[2], scale * quad[3]};
  std::array<Vec2, 4> p;
  flatten_all(corners, p);
  return turn(p[0], p[1], p[2]) > 0 && turn(p[1], p[2], p[3]) > 0 && turn(p[2], p[3], p[0]) > 0 &&
         turn(p[3], p[0], p[1]) > 0;
}

}  // namespace

bool triangulate(std::span<const Vec3> polygon, std::vector<std::array<int, 3>>& triangles) {
  if (polygon.size() == 3) {
    if (!triangle_has_area(polygon)) return false;
    triangles.push_back({0, 1, 2});
    return true;
  }
  if (polygon.size() == 4 && is_convex(polygon.first<4>())) {
    triangles.insert(triangles.end(), {{0, 1, 2}, {0, 2, 3}});
    return true;
  }
  std::vector<int> names;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    if (names.empty() || polygon[static_cast<std::size_t>(names.back())] != polygon[i]) {
      names.push_back(static_cast<int>(i));
    }
  }
  while (names.size() > 1 && polygon[static_cast<std::size_t>(names.back())] == polygon[0]) names.pop_back();
  if (names.size() < 3) return false;

  const double scale = exact_scale(polygon);
  std::vector<Vec3> corners;
  for (int i : names) corners.push_back(scale * polygon[static_cast<std::size_t>(i)]);
  std::vector<Vec2> points(corners.size());
  flatten_all(corners, points);
  const std::size_t before = triangles.size();
  if (EarClipper(points, names).clip(triangles)) return true;
  triangles.resize(before);
  return false;
}

Vec3 triangle_normal(const Vec3& p0, const Vec3& p1, const Vec3& p2) {
  const std::array corners{p0, p1, p2};
  const double scale = exact_scale(corners);
  const Vec3 a = normalized(scale * p1 - scale * p0), b = normalized(scale * p2 - scale * p0);
  const Vec3 n = cross(a, b);
  return n == Vec3{} ? orthonormal_basis(a)[0] : normalized(n);
}

}  // namespace strahl
