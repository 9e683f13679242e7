// SPDX-License-Identifier: MIT
// Planes, triangles, parallelograms, disks.
#include "oracle/draw.h"

namespace strahl::oracle {
namespace {

bool is_lattice(Law law) { return law == Law::exact_border || law == Law::in_surface; }

bool aims_at_border(Draw& draw) {
  return draw.law == Law::border || (draw.law == Law::axis_parallel && draw.one_in(2));
}

// Two sides from a corner: now and then a needle of 1 : 10 ... 1 : 10^7.
struct Sides {
  Point u, v;
};

Sides random_sides(Draw& draw) {
  const Point u = draw.direction(), v = draw.direction();
  const double thickness = draw.one_in(8) ? std::fabs(draw.random.log_uniform(-7, -1)) : 1;
  return {draw.size * u, draw.size * (draw.one_in(8) ? u + thickness * v : thickness * v)};
}

Sides lattice_sides(Draw& draw) {
  for (;;) {
    const Point u = draw.lattice_point(), v = draw.lattice_point(), n = cross(u, v);
    if (dot(n, n) > 0) return {u, v};
  }
}

// A lattice ray that lies in the plane of the sides, from a point in or beside the shape.
Ray in_plane_ray(Draw& draw, const Point& corner, const Sides& sides) {
  const auto combine = [&](int low, int high) {
    const double a = draw.random.integer(low, high), b = draw.random.integer(low, high);
    return a * sides.u + b * sides.v;
  };
  Point d = combine(-2, 2);
  if (dot(d, d) == 0) d = sides.u;
  return draw.lattice_ray(corner + 0.5 * combine(-3, 3), d);
}

// (u, v) of a point: 0, 1/2 or 1 on the border; a corner twice in three.
struct Place {
  double u, v;
};

Place triangle_place(Draw& draw, bool on_border) {
  Random& random = draw.random;
  if (!on_border) {
    const double u = random.uniform(), v = random.uniform();
    return u + v <= 1 ? Place{u, v} : Place{1 - u, 1 - v};
  }
  constexpr Place places[] = {{0, 0}, {1, 0}, {0, 1}, {0.5, 0}, {0, 0.5}, {0.5, 0.5}};
  const Place place = places[random.integer(0, 5)];
  if (draw.law == Law::exact_border) return place;
  const double along = random.uniform();
  const Place edges[] = {{along, 0}, {0, along}, {along, 1 - along}};
  return draw.one_in(2) ? place : edges[random.integer(0, 2)];
}

Place square_place(Draw& draw, bool on_border) {
  Random& random = draw.random;
  const double border = random.integer(0, 1);
  double along = random.uniform();
  if (draw.law == Law::exact_border || draw.one_in(3)) along = 0.5 * random.integer(0, 2);
  if (!on_border) return {random.uniform(), random.uniform()};
  return draw.one_in(2) ? Place{border, along} : Place{along, border};
}

}  // namespace

Case<Plane> plane_case(Random& random, Law law, Rounding rounding) {
  Draw draw(random, law, rounding);
  if (is_lattice(law)) {
    // Parallel rays: within the plane, or beside it.
    const Sides sides = lattice_sides(draw);
    const Point point = draw.lattice_point(), normal = cross(sides.u, sides.v);
    Ray ray = in_plane_ray(draw, point, sides);
    const Plane shape{draw.rounded(draw.lattice_scale * point), draw.rounded(normal)};
    if (law == Law::exact_border) ray.origin = draw.rounded(Point(ray.origin) + draw.lattice_scale * normal);
    return {ray, shape};
  }
  const Point n = draw.direction(), in_plane = draw.perpendicular(n);
  const double length = draw.one_in(2) ? 1 : std::fabs(random.log_uniform(-10, 10));
  const Plane shape{draw.rounded(draw.center), draw.rounded(length * n)};
  const Point target = draw.center + draw.size * random.uniform(0, 10) * in_plane;
  if (law != Law::border) return {draw.through(target), shape};
  const double tilt = random.log_uniform(-8, -1);
  return {draw.through(target, normalized(draw.perpendicular(n) + tilt * n)), shape};
}

Case<Triangle> triangle_case(Random& random, Law law, Rounding rounding) {
  Draw draw(random, law, rounding);
  if (is_lattice(law)) {
    const Sides sides = lattice_sides(draw);
    const Point corner = draw.lattice_point();
    const auto vertex = [&](const Point& p) { return draw.rounded(draw.lattice_scale * p); };
    const Triangle shape{vertex(corner), vertex(corner + sides.u), vertex(corner + sides.v)};
    if (law == Law::in_surface) return {in_plane_ray(draw, corner, sides), shape};
    const Place place = triangle_place(draw, true);
    return {draw.lattice_ray(corner + place.u * sides.u + place.v * sides.v), shape};
  }
  const Sides sides = random_sides(draw);
  const Triangle shape{draw.rounded(draw.center), draw.rounded(draw.center + sides.u),
                       draw.rounded(draw.center + sides.v)};
  const Place place = triangle_place(draw, aims_at_border(draw));
  const Point p0(shape.p0), p1(shape.p1), p2(shape.p2);
  return {draw.through(p0 + place.u * (p1 - p0) + place.v * (p2 - p0)), shape};
}

Case<Parallelogram> parallelogram_case(Random& random, Law law, Rounding rounding) {
  Draw draw(random, law, rounding);
  if (is_lattice(law)) {
    const Sides sides = lattice_sides(draw);
    const Point corner = draw.lattice_point();
    const auto scaled = [&](const Point& p) { return draw.rounded(draw.lattice_scale * p); };
    const Parallelogram shape{scaled(corner), scaled(sides.u), scaled(sides.v)};
    if (law == Law::in_surface) return {in_plane_ray(draw, corner, sides), shape};
    const Place place = square_place(draw, true);
    return {draw.lattice_ray(corner + place.u * sides.u + place.v * sides.v), shape};
  }
  const Sides sides = random_sides(draw);
  const Parallelogram shape{draw.rounded(draw.center), draw.rounded(sides.u), draw.rounded(sides.v)};
  const Place place = square_place(draw, aims_at_border(draw));
  return {draw.through(Point(shape.corner) + place.u * Point(shape.edge_u) + place.v * Point(shape.edge_v)), shape};
}

Case<Disk> disk_case(Random& random, Law law, Rounding rounding) {
  Draw draw(random, law, rounding);
  if (is_lattice(law)) {
    // A disk across a coordinate axis, the target (3, 4) or (4, 3) of 5 from its centre, so exactly on the rim.
    const int k = 2 * random.integer(1, 4);
    const double a = 3.0 * k * random.sign(), b = 4.0 * k * random.sign(), r = 5.0 * k;
    const int axis = random.integer(0, 2);
    const auto turned = [&](double x, double y) {
      return axis == 0 ? Point(0, x, y) : axis == 1 ? Point(y, 0, x) : Point(x, y, 0);
    };
    const Sides sides{turned(r, 0), turned(0, r)};
    const Point center = draw.lattice_point(), rim = draw.one_in(2) ? turned(a, b) : turned(b, a);
    const auto scaled = [&](const Point& p) { return draw.rounded(draw.lattice_scale * p); };
    const Disk shape{scaled(center), scaled(sides.u), scaled(sides.v), draw.rounded(draw.lattice_scale * r)};
    if (law == Law::in_surface) return {in_plane_ray(draw, center, sides), shape};
    return {draw.lattice_ray(center + rim), shape};
  }
  const Point n = draw.direction(), u = draw.perpendicular(n), v = cross(n, u);
  const Disk shape{draw.rounded(draw.center), draw.rounded(draw.size * u), draw.rounded(draw.size * v),
                   draw.rounded(draw.size)};
  const double angle = random.uniform(0, 2 * M_PI);
  const double away = draw.size * (aims_at_border(draw) ? 1 : std::sqrt(random.uniform()));
  return {draw.through(draw.center + away * std::cos(angle) * u + away * std::sin(angle) * v), shape};
}

}  // namespace strahl::oracle
