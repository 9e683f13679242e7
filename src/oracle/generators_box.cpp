// SPDX-License-Identifier: MIT
// Axis-aligned boxes, now and then flat or a point.
#include <algorithm>

#include "oracle/draw.h"

namespace strahl::oracle {
namespace {

using Triple = std::array<double, 3>;

Triple triple(const Vec3& v) { return {v.x, v.y, v.z}; }
Vec3 vec3(const Triple& t) { return {t[0], t[1], t[2]}; }

Aabb random_box(Draw& draw) {
  const bool is_lattice = draw.law == Law::exact_border;
  const bool is_flat = draw.one_in(8), is_point = draw.one_in(16);
  const auto extent = [&] {
    return is_lattice ? 2.0 * draw.random.integer(0, 8) : draw.size * draw.random.uniform(0.1, 1);
  };
  const Point low = is_lattice ? draw.lattice_point() : draw.center;
  const Point high = low + Point{is_flat || is_point ? 0 : extent(), is_point ? 0 : extent(), is_point ? 0 : extent()};
  return {draw.rounded(draw.lattice_scale * low), draw.rounded(draw.lattice_scale * high)};
}

// A point of the box: inside, in a face, on an edge, at a corner (fixed axes 0, 1, 2, 3).
Point place(Draw& draw, const Aabb& box, int fixed) {
  const Triple low = triple(box.min), high = triple(box.max);
  Triple p{};
  const int first = draw.random.integer(0, 2);
  for (int k = 0; k < 3; ++k) {
    const auto i = static_cast<std::size_t>((first + k) % 3);
    const bool is_exact = draw.law == Law::exact_border;
    const double share = k < fixed ? draw.random.integer(0, 1) : is_exact ? 0.5 : draw.random.uniform();
    p[i] = share == 1 ? high[i] : low[i] + share * (high[i] - low[i]);
  }
  return Point(vec3(p));
}

}  // namespace

Case<Aabb> aabb_case(Random& random, Law law, Rounding rounding) {
  Draw draw(random, law, rounding);
  const Aabb box = random_box(draw);
  const bool at_border =
      law == Law::border || law == Law::exact_border || (law == Law::axis_parallel && draw.one_in(2));
  const Point target = place(draw, box, at_border ? random.integer(1, 3) : 0);
  if (law == Law::exact_border) return {draw.lattice_ray(1 / draw.lattice_scale * target), box};
  Ray ray = draw.through(target);
  if (law == Law::in_surface) {
    // Pin the ray into a face: the face's own coordinate, a zero of either sign.
    const auto axis = static_cast<std::size_t>(random.integer(0, 2));
    Triple o = triple(ray.origin), d = triple(ray.direction);
    o[axis] = draw.one_in(2) ? triple(box.min)[axis] : triple(box.max)[axis];
    d[axis] = random.sign() * 0.0;
    ray.origin = vec3(o);
    ray.direction = vec3(d);
  }
  return {ray, box};
}

}  // namespace strahl::oracle
