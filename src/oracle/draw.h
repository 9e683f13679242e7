// SPDX-License-Identifier: MIT
// What the generators share: where a shape stands and how large it is, rays towards a point, integer lattices,
// rounding.
#pragma once

#include "oracle/generators.h"
#include "oracle/number.h"

namespace strahl::oracle {

using Point = Vector<double>;

class Draw {
 public:
  Draw(Random& generator, Law kind, Rounding rounding);

  Random& random;
  const Law law;
  /// Where the shape stands, how large it is; zero and one for the lattice laws.
  Point center{0, 0, 0};
  double size = 1;

  [[nodiscard]] double rounded(double x) const;
  [[nodiscard]] Vec3 rounded(const Point& p) const { return {rounded(p.x), rounded(p.y), rounded(p.z)}; }

  /// Uniform on the unit sphere.
  [[nodiscard]] Point direction();
  /// A unit vector perpendicular to the unit vector n.
  [[nodiscard]] Point perpendicular(const Point& n);
  /// Even integers of absolute value up to reach, so that midpoints are on the lattice too.
  [[nodiscard]] Point lattice_point(int reach = 20);
  /// True with the probability one in n.
  [[nodiscard]] bool one_in(int n) { return random.integer(1, n) == 1; }

  /// A ray through target as the law asks for (direction, its length, distance, range of t), rounded.
  [[nodiscard]] Ray through(const Point& target);
  /// The same along the given unit direction.
  [[nodiscard]] Ray through(const Point& target, const Point& along);
  /// A ray of exact integers through the lattice point target, from a lattice point elsewhere, scaled by lattice_scale.
  [[nodiscard]] Ray lattice_ray(const Point& target);
  /// The ray from origin along d, both on the lattice.
  [[nodiscard]] Ray lattice_ray(const Point& origin, const Point& d) const;
  /// A power of two, the lattice's spacing in world units.
  double lattice_scale = 1;

 private:
  void draw_range(Ray& ray, double t_of_target);

  Rounding rounding_;
};

[[nodiscard]] inline Point normalized(const Point& v) { return 1 / std::sqrt(dot(v, v)) * v; }

}  // namespace strahl::oracle
