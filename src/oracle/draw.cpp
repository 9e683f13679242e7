// SPDX-License-Identifier: MIT
// Several draws in one expression stand in braces, which fix their order, never among the arguments of a call.
#include "oracle/draw.h"

#include <algorithm>
#include <limits>

namespace strahl::oracle {

Draw::Draw(Random& generator, Law kind, Rounding rounding) : random(generator), law(kind), rounding_(rounding) {
  const auto spread = [&](double low, double high) {
    return Point{random.log_uniform(low, high), random.log_uniform(low, high), random.log_uniform(low, high)};
  };
  switch (law) {
    case Law::log_uniform:
      center = spread(-8, 8);
      size = std::fabs(random.log_uniform(-8, 8));
      return;
    case Law::offset:
      center = spread(3, 7);
      size = std::fabs(random.log_uniform(-1, 2));
      return;
    case Law::extreme: {
      const bool is_tiny = one_in(2);
      size = std::fabs(is_tiny ? random.log_uniform(-43, -38) : random.log_uniform(15, 18));
      center = size * spread(-1, 1);
      return;
    }
    case Law::exact_border:
    case Law::in_surface:
      lattice_scale = std::ldexp(1.0, random.integer(-10, 10));
      return;
    case Law::aimed:
    case Law::border:
    case Law::axis_parallel:
    case Law::unnormalised:
      center = spread(-1, 2);
      size = std::fabs(random.log_uniform(-2, 1));
      return;
  }
}

double Draw::rounded(double x) const {
  if (rounding_ == Rounding::to_double) return x;
  // volatile: at -O2, g++ 12.2 drops double -> float -> double when it vectorises neighbouring components.
  const volatile float narrow = static_cast<float>(x);
  return static_cast<double>(narrow);
}

Point Draw::direction() {
  for (;;) {
    const Point p{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    const double squared = dot(p, p);
    if (squared > 1e-4 && squared <= 1) return normalized(p);
  }
}

Point Draw::perpendicular(const Point& n) {
  for (;;) {
    const Point p = cross(n, direction());
    if (dot(p, p) > 1e-4) return normalized(p);
  }
}

Point Draw::lattice_point(int reach) {
  const auto even = [&] { return 2.0 * random.integer(-reach / 2, reach / 2); };
  return {even(), even(), even()};
}

Ray Draw::through(const Point& target) {
  if (law != Law::axis_parallel) return through(target, direction());
  std::array<double, 3> d{};
  for (double& component : d) component = random.sign() * 0.0;
  const int first = random.integer(0, 2);
  d[static_cast<std::size_t>(first)] = random.sign();
  if (one_in(3)) d[static_cast<std::size_t>((first + 1) % 3)] = random.uniform(-1, 1);
  return through(target, {d[0], d[1], d[2]});
}

Ray Draw::through(const Point& target, const Point& along) {
  // From 0.1 to 10^4 sizes away; behind the origin, or right at it, now and then.
  double distance = size * std::fabs(random.log_uniform(-1, law == Law::offset || law == Law::extreme ? 1 : 4));
  if (one_in(16)) distance = -distance;
  if (one_in(32)) distance = 0;
  double length = one_in(2) ? 1 : random.uniform(0.1, 10);
  if (law == Law::unnormalised) length = std::fabs(random.log_uniform(-20, 18));
  if (law == Law::log_uniform) length = std::fabs(random.log_uniform(-8, 8));
  Ray ray;
  const Point origin = target - distance * along;
  ray.origin = rounded(origin);
  // Aimed from the rounded origin, unless zero components have to stay.
  const Point to_target = target - Point(ray.origin);
  const bool aims = law == Law::offset && distance > 0 && dot(to_target, to_target) > 0;
  ray.direction = rounded(length * (aims ? normalized(to_target) : along));
  draw_range(ray, distance / length);
  return ray;
}

Ray Draw::lattice_ray(const Point& target) {
  for (;;) {
    const Point origin = lattice_point(60), d = target - origin;
    if (dot(d, d) > 0) return lattice_ray(origin, d);
  }
}

Ray Draw::lattice_ray(const Point& origin, const Point& d) const {
  Ray ray;
  ray.origin = rounded(lattice_scale * origin);
  ray.direction = rounded(d);
  return ray;
}

void Draw::draw_range(Ray& ray, double t_of_target) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  switch (random.integer(0, 7)) {
    case 0:
      ray.t_min = -infinity;
      return;
    case 1:
      ray.t_max = rounded(std::fabs(t_of_target) * random.uniform(0.5, 1.5));
      return;
    case 2:
      ray.t_min = rounded(std::fabs(t_of_target) * random.uniform(0, 1.2));
      return;
    default:
      return;
  }
}

}  // namespace strahl::oracle
