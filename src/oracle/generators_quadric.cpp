// SPDX-License-Identifier: MIT
// Spheres and cylinders. A tangent-seeking case chooses the ray first and rounds it, then takes the radius from the
// distance of that ray, |1 - L / r| = 2^-10 ... 2^-24; an exactly tangent one is built from integer vectors n, d with
// n . d = 0 and |n| an integer.
#include "oracle/draw.h"

namespace strahl::oracle {
namespace {

struct Tangent {
  Point normal;
  double length;
};

constexpr double tangent_normals[][4] = {{3, 4, 0, 5}, {1, 2, 2, 3},  {2, 3, 6, 7}, {1, 4, 8, 9},
                                         {4, 4, 7, 9}, {2, 6, 9, 11}, {1, 0, 0, 1}};

Tangent exact_tangent(Random& random) {
  const auto& row = tangent_normals[random.integer(0, 6)];
  const int turn = random.integer(0, 2);
  const auto component = [&](int i) { return random.sign() * row[(i + turn) % 3]; };
  const double x = component(0), y = component(1), z = component(2);
  const int k = random.integer(1, 8);
  return {{k * x, k * y, k * z}, k * row[3]};
}

Point lattice_perpendicular(Draw& draw, const Point& n) {
  for (;;) {
    const Point d = cross(n, draw.lattice_point(4));
    if (dot(d, d) > 0) return d;
  }
}

// |f x d| / |d| in long double: the radius is rounded anyway, its own value is what counts.
double line_distance(const Ray& ray, const Vec3& point) {
  const Vector<long double> d(ray.direction), f = Vector<long double>(ray.origin) - Vector<long double>(point);
  const Vector<long double> moment = cross(f, d);
  return static_cast<double>(std::sqrt(dot(moment, moment) / dot(d, d)));
}

double seek_tangent(Draw& draw, double distance) {
  const double fraction = draw.random.uniform(0.5, 1), off = std::ldexp(fraction, -draw.random.integer(10, 23));
  return draw.rounded(distance / (1 + draw.random.sign() * off));
}

Point inside(Draw& draw) {
  const double away = draw.size * draw.random.uniform(0, 0.999);
  return away * draw.direction();
}

}  // namespace

Case<Sphere> sphere_case(Random& random, Law law, Rounding rounding) {
  Draw draw(random, law, rounding);
  if (law == Law::exact_border || law == Law::in_surface) {
    const Tangent tangent = exact_tangent(random);
    const Point center = draw.lattice_point(), touched = center + tangent.normal;
    const Point d = lattice_perpendicular(draw, tangent.normal);
    const Sphere shape{draw.rounded(draw.lattice_scale * center), draw.rounded(draw.lattice_scale * tangent.length)};
    // In the surface: from the touched point itself, tangent, outwards or inwards.
    if (law == Law::exact_border) return {draw.lattice_ray(touched - random.integer(0, 9) * d, d), shape};
    const double lift = random.integer(-1, 1);
    return {draw.lattice_ray(touched, d + lift * tangent.normal), shape};
  }
  Sphere shape{draw.rounded(draw.center), draw.rounded(draw.size)};
  if (law == Law::border) {
    Ray ray = draw.through(draw.center + draw.size * draw.direction());
    const double distance = line_distance(ray, shape.center);
    shape.radius = distance > 0 ? seek_tangent(draw, distance) : shape.radius;
    return {ray, shape};
  }
  if (law == Law::axis_parallel && draw.one_in(2)) {
    // Touches the rounded sphere's outermost coordinate.
    const double top = draw.rounded(shape.center.y + shape.radius);
    return {draw.through({shape.center.x, top, shape.center.z}, {random.sign() * 1.0, 0, 0}), shape};
  }
  if (law == Law::log_uniform && draw.one_in(2)) return {draw.through(Draw(random, law, rounding).center), shape};
  return {draw.through(draw.center + inside(draw)), shape};
}

Case<Cylinder> cylinder_case(Random& random, Law law, Rounding rounding) {
  Draw draw(random, law, rounding);
  if (law == Law::exact_border || law == Law::in_surface) {
    const Tangent tangent = exact_tangent(random);
    const Point p0 = draw.lattice_point(), axis = lattice_perpendicular(draw, tangent.normal);
    const Cylinder shape{draw.rounded(draw.lattice_scale * p0), draw.rounded(draw.lattice_scale * axis),
                         draw.rounded(draw.lattice_scale * tangent.length)};
    // Tangent at either end, between, or beyond; or along the axis within the mantle; or at a point of a rim.
    const Point on_mantle = p0 + tangent.normal + random.integer(0, 2) * 0.5 * axis;
    if (law == Law::in_surface) {
      const Point along = draw.one_in(2) ? axis : cross(axis, tangent.normal) + random.integer(-1, 1) * tangent.normal;
      return {draw.lattice_ray(on_mantle, along), shape};
    }
    if (draw.one_in(2)) return {draw.lattice_ray(on_mantle), shape};
    const Point d = cross(axis, tangent.normal) + random.integer(-1, 1) * axis;
    return {draw.lattice_ray(on_mantle - random.integer(0, 9) * d, d), shape};
  }
  const Point axis_direction = draw.direction();
  const double length = draw.size * std::fabs(random.log_uniform(-1, 1));
  const Point axis = length * axis_direction;
  Cylinder shape{draw.rounded(draw.center), draw.rounded(axis), draw.rounded(draw.size)};
  const Point out = draw.perpendicular(axis_direction);
  if (law == Law::border && draw.one_in(2)) {
    Ray ray = draw.through(draw.center + random.uniform() * axis + draw.size * out);
    const Vector<long double> v(shape.axis), d(ray.direction);
    const Vector<long double> across = cross(d, v), f = Vector<long double>(ray.origin) - Vector<long double>(shape.p0);
    const long double squared = dot(across, across);
    if (squared > 0)
      shape.radius = seek_tangent(draw, static_cast<double>(std::fabs(dot(f, across)) / std::sqrt(squared)));
    return {ray, shape};
  }
  const bool aims_at_rim = law == Law::border || (law == Law::axis_parallel && draw.one_in(2));
  const double place = aims_at_rim ? random.integer(0, 1) : random.uniform();
  return {draw.through(draw.center + place * axis + draw.size * out), shape};
}

}  // namespace strahl::oracle
