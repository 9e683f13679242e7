// SPDX-License-Identifier: MIT
// One function a kind of shape. Bands and what t_rounding covers: docs/decisions/0007-robust-tier.md.
#include "selftest/questions.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace strahl::selftest {

void put(std::vector<double>& planes, const Vec3& v) {
  for (const double x : {v.x, v.y, v.z}) planes.push_back(narrow(x));
}

void settle(Question& q, const oracle::Answer& answer, bool is_outside_band) {
  const bool is_decided = is_outside_band && answer.range_margin >= 4 * u;
  q.expected = !is_decided ? Expected::either : answer.hit ? Expected::hit : Expected::miss;
  q.primitive = answer.hit ? 0 : -1;
  q.t = answer.t;
}

namespace {

using oracle::Law;

Vec3 at(const std::vector<double>& planes, std::size_t i) { return {planes[i], planes[i + 1], planes[i + 2]}; }

Question question(const char* kind, const oracle::Ray& ray) {
  Question q;
  q.kind = kind;
  q.ray = ray;
  return q;
}

double distance_in_t(const Question& q, const Vec3& point, double size) {
  return (length(q.ray.origin - point) + size) / length(q.ray.direction);
}

/// Band: 4 u of 1 - (L / r)^2. Ratios of radius and distance below 10^-7 are not promised.
Question sphere_question(oracle::Random& random, Law law) {
  const auto drawn = oracle::sphere_case(random, law, oracle::Rounding::to_float);
  const oracle::Sphere& s = drawn.shape;
  Question q = question("sphere", drawn.ray);
  put(q.planes, s.center);
  q.planes.push_back(narrow(s.radius));
  const auto answer = oracle::sphere(q.ray, s);
  const bool is_seen = s.radius >= 1e-7 * length(q.ray.origin - s.center);
  settle(q, answer, is_seen && std::fabs(answer.margin) > 4 * u);
  q.t_rounding = 16 * u * u * distance_in_t(q, s.center, s.radius);
  return q;
}

/// The axis is what the device holds: a unit vector, rounded, times the length, rounded. Ratios of radius or length and
/// distance below 10^-6 are not promised.
Question cylinder_question(oracle::Random& random, Law law) {
  const auto drawn = oracle::cylinder_case(random, law, oracle::Rounding::to_float);
  Question q = question("cylinder", drawn.ray);
  put(q.planes, drawn.shape.p0);
  put(q.planes, normalized(drawn.shape.axis));
  q.planes.push_back(narrow(length(drawn.shape.axis)));
  q.planes.push_back(narrow(drawn.shape.radius));
  const double size = q.planes[6];
  const oracle::Cylinder s{at(q.planes, 0), size * at(q.planes, 3), q.planes[7]};
  const auto answer = oracle::cylinder(q.ray, s);
  const bool is_seen = std::fmin(s.radius, size) >= 1e-6 * length(q.ray.origin - s.p0);
  // A crossing at the range's end, where t is 0 to rounding.
  const double near_zero = 16 * u * u * distance_in_t(q, s.p0, size + s.radius);
  bool is_at_start = false;
  if (answer.discriminant_sign >= 0)
    for (const auto& root : answer.root) is_at_start |= std::fabs(root.value - q.ray.t_min) <= near_zero;
  settle(q, answer, is_seen && !is_at_start && std::fabs(answer.margin) > 4 * u);
  const double sine = length(cross(normalized(q.ray.direction), normalized(s.axis)));
  q.t_rounding = 16 * u * u * distance_in_t(q, s.p0, size + s.radius) / (sine * std::sqrt(std::fabs(answer.margin)));
  return q;
}

Question plane_question(oracle::Random& random, Law law) {
  const auto drawn = oracle::plane_case(random, law, oracle::Rounding::to_float);
  Question q = question("plane", drawn.ray);
  put(q.planes, drawn.shape.point);
  put(q.planes, drawn.shape.normal);
  const auto answer = oracle::plane(q.ray, drawn.shape);
  settle(q, answer, answer.margin >= 1e-7);
  return q;
}

/// Axes that span the packed normal's plane exactly: their cross product is a multiple of it.
Question disk_question(oracle::Random& random, Law law) {
  const auto drawn = oracle::disk_case(random, law, oracle::Rounding::to_float);
  Question q = question("disk", drawn.ray);
  put(q.planes, drawn.shape.center);
  put(q.planes, cross(drawn.shape.axis_u, drawn.shape.axis_v));
  q.planes.push_back(narrow(dot(drawn.shape.axis_u, drawn.shape.axis_u)));
  const Vec3 n = at(q.planes, 3);
  const double x = std::fabs(n.x), y = std::fabs(n.y), z = std::fabs(n.z);
  oracle::Disk s{at(q.planes, 0), {n.y, -n.x, 0}, {n.z, 0, -n.x}, std::sqrt(static_cast<double>(q.planes[6]))};
  if (y > x && y >= z) s.axis_u = {0, n.z, -n.y}, s.axis_v = {-n.y, n.x, 0};
  if (z > x && z > y) s.axis_u = {-n.z, 0, n.x}, s.axis_v = {0, -n.z, n.y};
  const auto answer = oracle::disk(q.ray, s);
  const double cosine = std::fabs(dot(normalized(q.ray.direction), normalized(n)));
  settle(q, answer, cosine >= 1e-7 && std::fabs(answer.margin) > 4 * u);
  return q;
}

Question box_question(oracle::Random& random, Law law) {
  const auto drawn = oracle::aabb_case(random, law, oracle::Rounding::to_float);
  const oracle::Aabb& s = drawn.shape;
  Question q = question("box", drawn.ray);
  for (const double x : {s.min.x, s.max.x, s.min.y, s.max.y, s.min.z, s.max.z}) q.planes.push_back(narrow(x));
  const auto answer = oracle::aabb(q.ray, s);
  settle(q, answer, true);
  return q;
}

/// Band: 4 u of the edge functions (vertices are sheared in float, consistently, so meshes do not leak). t is promised
/// where it is not within that of 0.
void settle_planar(Question& q, const oracle::PlanarAnswer& answer, std::size_t corners, double closes) {
  double scale = 0;
  for (std::size_t i = 0; i < corners; ++i) scale = std::fmax(scale, length(at(q.planes, 3 * i) - q.ray.origin));
  const double away = 16 * u * scale / (answer.cosine * length(q.ray.direction));
  settle(q, answer, answer.cosine >= 1e-7 && std::fabs(answer.margin) > 4 * u + closes);
  const auto far_from = [&](double bound) { return !(std::fabs(answer.t.value - bound) <= away); };
  if (!far_from(0) || !far_from(q.ray.t_min) || !far_from(q.ray.t_max)) q.expected = Expected::either;
}

Question triangle_question(oracle::Random& random, Law law) {
  const auto drawn = oracle::triangle_case(random, law, oracle::Rounding::to_float);
  Question q = question("triangle", drawn.ray);
  for (const Vec3& p : {drawn.shape.p0, drawn.shape.p1, drawn.shape.p2}) put(q.planes, p);
  settle_planar(q, oracle::triangle(q.ray, drawn.shape), 3, 0);
  return q;
}

/// Four corners are packed, each rounded; the band grows by what keeps them from closing, and those that it distorts
/// are not asked about.
Question parallelogram_question(oracle::Random& random, Law law) {
  const auto drawn = oracle::parallelogram_case(random, law, oracle::Rounding::to_float);
  const oracle::Parallelogram& given = drawn.shape;
  Question q = question("parallelogram", drawn.ray);
  put(q.planes, given.corner);
  put(q.planes, given.corner + given.edge_u);
  put(q.planes, given.corner + given.edge_u + given.edge_v);
  put(q.planes, given.corner + given.edge_v);
  const oracle::Parallelogram s{at(q.planes, 0), at(q.planes, 3) - at(q.planes, 0), at(q.planes, 9) - at(q.planes, 0)};
  const Vec3 c = at(q.planes, 6);
  const double gap = length(s.corner + s.edge_u + s.edge_v - c);
  const double height = length(cross(s.edge_u, s.edge_v)) / std::fmax(length(s.edge_u), length(s.edge_v));
  settle_planar(q, oracle::parallelogram(q.ray, s), 4, 4 * gap / length(c - q.ray.origin));
  if (!(gap <= 0x1p-10 * height)) q.expected = Expected::either;
  return q;
}

}  // namespace

Question draw_question(const std::string& kind, Law law, oracle::Random& random) {
  struct Kind {
    const char* name;
    Question (*draw)(oracle::Random&, Law);
  };
  static constexpr Kind kinds[] = {{"sphere", sphere_question},
                                   {"plane", plane_question},
                                   {"box", box_question},
                                   {"triangle", triangle_question},
                                   {"parallelogram", parallelogram_question},
                                   {"disk", disk_question},
                                   {"cylinder", cylinder_question}};
  const auto* found = std::find_if(std::begin(kinds), std::end(kinds), [&](const Kind& k) { return kind == k.name; });
  if (found == std::end(kinds)) throw std::logic_error("no questions are drawn about shapes of kind " + kind);
  return found->draw(random, law);
}

}  // namespace strahl::selftest
