// SPDX-License-Identifier: MIT
// One function a kind of shape; the planes are those that cl/shapes/<kind>.h states.
#include "selftest/answer.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>

#include "oracle/number.h"
#include "selftest/to_float.h"

namespace strahl::selftest {
namespace {

using Planes = const double*;

Vec3 at(Planes planes) { return {planes[0], planes[1], planes[2]}; }

struct Asked {
  const oracle::Ray& ray;
  Planes planes;
  bool has_left;
};

/// Products of three lengths must stay within float.
bool is_in_scale(double length) { return length >= 0x1p-40 && length <= 0x1p40; }

/// Size of what the ray sees, in units of t.
double reach(const oracle::Ray& ray, const Vec3& point, double size) {
  return (length(ray.origin - point) + size) / length(ray.direction);
}

ExactAnswer from(const oracle::Answer& answer, bool is_outside_band) {
  return {answer.hit, 0, true, answer.t, is_outside_band && answer.range_margin >= 4 * u};
}

/// The root of a quadric that was left: hit where t > 0 and in range.
ExactAnswer other_root(const oracle::Ray& ray, const mpq_class& t) {
  ExactAnswer answer;
  answer.hit = sgn(t) > 0 && oracle::in_range(ray, t);
  answer.t = oracle::to_exact(t);
  return answer;
}

ExactAnswer sphere(const Asked& q) {
  const oracle::Sphere shape{at(q.planes), q.planes[3]};
  const double away = length(q.ray.origin - shape.center);
  if (q.has_left) {
    const oracle::Vector<mpq_class> d(q.ray.direction);
    const auto f = oracle::Vector<mpq_class>(q.ray.origin) - oracle::Vector<mpq_class>(shape.center);
    ExactAnswer answer = other_root(q.ray, mpq_class(-2 * oracle::dot(f, d) / oracle::dot(d, d)));
    answer.is_promised = is_in_scale(shape.radius) && is_in_scale(away);
    return answer;
  }
  const auto met = oracle::sphere(q.ray, shape);
  const bool is_seen = shape.radius >= 1e-7 * away && is_in_scale(shape.radius) && is_in_scale(shape.radius + away);
  ExactAnswer answer = from(met, is_seen && std::fabs(met.margin) > 4 * u);
  answer.t_rounding = 16 * u * u * reach(q.ray, shape.center, shape.radius);
  return answer;
}

ExactAnswer cylinder(const Asked& q) {
  const Vec3 p0 = at(q.planes), unit = at(q.planes + 3);
  const double extent = q.planes[6];
  const oracle::Cylinder shape{p0, extent * unit, q.planes[7]};
  const double sine = length(cross(normalized(q.ray.direction), normalized(unit)));
  if (q.has_left) {
    using Exactly = oracle::Vector<mpq_class>;
    const Exactly v(unit), d(q.ray.direction), f = Exactly(q.ray.origin) - Exactly(p0), across = oracle::cross(d, v);
    if (sgn(oracle::dot(across, across)) == 0) return {};
    const mpq_class t = -2 * oracle::dot(oracle::cross(f, v), across) / oracle::dot(across, across);
    const mpq_class place = oracle::dot(f, v) + t * oracle::dot(d, v), end = mpq_class(extent) * oracle::dot(v, v);
    ExactAnswer answer = other_root(q.ray, t);
    answer.hit = answer.hit && sgn(place) >= 0 && place <= end;
    const double margin = std::fmin(std::fabs(place.get_d()), std::fabs(mpq_class(end - place).get_d())) / extent;
    answer.is_promised = margin > 4 * u && is_in_scale(q.planes[7]) && is_in_scale(length(q.ray.origin - p0) + extent);
    answer.t_rounding = 32 * u * u * reach(q.ray, p0, 0) / sine;
    return answer;
  }
  const auto met = oracle::cylinder(q.ray, shape);
  const double away = length(q.ray.origin - p0), size = std::fmin(shape.radius, extent);
  const bool is_seen = size >= 1e-6 * away && is_in_scale(size) && is_in_scale(shape.radius + extent + away);
  ExactAnswer answer = from(met, is_seen && std::fabs(met.margin) > 4 * u);
  answer.t_rounding = 16 * u * u * reach(q.ray, p0, extent + shape.radius) / (sine * std::sqrt(std::fabs(met.margin)));
  // A crossing at the range's end, where t is 0 to rounding.
  if (met.discriminant_sign >= 0)
    for (const auto& root : met.root)
      if (std::fabs(root.value - q.ray.t_min) <= answer.t_rounding) answer.is_promised = false;
  return answer;
}

ExactAnswer plane(const Asked& q) {
  if (q.has_left) return {};
  const auto met = oracle::plane(q.ray, {at(q.planes), at(q.planes + 3)});
  const double away = length(q.ray.origin - at(q.planes)) + length(at(q.planes));
  return from(met, met.margin >= 1e-7 && is_in_scale(length(at(q.planes + 3))) && (away == 0 || is_in_scale(away)));
}

/// Axes that span the plane of the normal exactly: their cross product is a multiple of it.
oracle::Disk disk_of(Planes planes) {
  const Vec3 n = at(planes + 3);
  const double x = std::fabs(n.x), y = std::fabs(n.y), z = std::fabs(n.z);
  oracle::Disk shape{at(planes), {n.y, -n.x, 0}, {n.z, 0, -n.x}, std::sqrt(planes[6])};
  if (y > x && y >= z) shape.axis_u = {0, n.z, -n.y}, shape.axis_v = {-n.y, n.x, 0};
  if (z > x && z > y) shape.axis_u = {-n.z, 0, n.x}, shape.axis_v = {0, -n.z, n.y};
  return shape;
}

ExactAnswer disk(const Asked& q) {
  if (q.has_left) return {};
  const auto met = oracle::disk(q.ray, disk_of(q.planes));
  const double cosine = std::fabs(dot(normalized(q.ray.direction), normalized(at(q.planes + 3))));
  const double away = length(q.ray.origin - at(q.planes));
  // Of the normal the square root, as it may come as the product of two radii.
  const double size = std::sqrt(q.planes[6]), unit = std::sqrt(length(at(q.planes + 3)));
  const bool is_seen = is_in_scale(size) && is_in_scale(unit) && away <= 0x1p40;
  return from(met, is_seen && cosine >= 1e-7 && std::fabs(met.margin) > 4 * u);
}

ExactAnswer box(const Asked& q) {
  const oracle::Aabb shape{{q.planes[0], q.planes[2], q.planes[4]}, {q.planes[1], q.planes[3], q.planes[5]}};
  const auto met = oracle::aabb(q.ray, shape);
  // The robust tier has no band, the double one that of its own rounding.
  if (!q.has_left) return from(met, met.margin == 0 || std::fabs(met.margin) > 0x1p-50);
  ExactAnswer answer;
  answer.t = met.exit;
  answer.hit = met.line_meets && met.exit.value > 0 && met.exit.value <= q.ray.t_max;
  return answer;
}

/// How far the ray's origin is from the corners.
double scale_of(const Asked& q, int corners) {
  double scale = 0;
  for (int i = 0; i < corners; ++i) scale = std::fmax(scale, length(at(q.planes + 3 * i) - q.ray.origin));
  return scale;
}

ExactAnswer polygon(const Asked& q, const oracle::PlanarAnswer& met, int corners, double closes) {
  ExactAnswer answer = from(met, met.cosine >= 1e-7 && std::fabs(met.margin) > 8 * u + closes);
  if (met.is_parallel) return answer;
  const double scale = scale_of(q, corners);
  if (!is_in_scale(scale)) answer.is_promised = false;
  const double away = 16 * u * scale / (met.cosine * length(q.ray.direction));
  for (const double bound : {0.0, q.ray.t_min, q.ray.t_max})
    if (std::fabs(met.t.value - bound) <= away) answer.is_promised = false;
  // A ray aimed at the edge may meet the neighbour instead, whose t there is within that of this one's.
  if (!answer.is_promised) answer.t_rounding = away;
  return answer;
}

ExactAnswer triangle(const Asked& q) {
  if (q.has_left) return {};
  return polygon(q, oracle::triangle(q.ray, {at(q.planes), at(q.planes + 3), at(q.planes + 6)}), 3, 0);
}

/// Four rounded corners need not close: the band grows by the gap, and those that it distorts are not promised.
ExactAnswer parallelogram(const Asked& q) {
  if (q.has_left) return {};
  const Vec3 a = at(q.planes), c = at(q.planes + 6);
  const oracle::Parallelogram shape{a, at(q.planes + 3) - a, at(q.planes + 9) - a};
  const double gap = length(a + shape.edge_u + shape.edge_v - c);
  const double longest = std::fmax(length(shape.edge_u), length(shape.edge_v));
  const double height = length(cross(shape.edge_u, shape.edge_v)) / longest;
  const double closes = gap == 0 ? 0 : 4 * gap / length(c - q.ray.origin);
  ExactAnswer answer = polygon(q, oracle::parallelogram(q.ray, shape), 4, closes);
  if (gap > 0x1p-10 * height) answer.is_promised = false;
  return answer;
}

struct Kind {
  const char* name;
  int planes;
  ExactAnswer (*ask)(const Asked&);
};

constexpr Kind kinds[] = {
#define SHAPE(name, planes) {#name, planes, name},
#include "../../cl/shapes/shapes.def"
#undef SHAPE
};

const Kind& kind_of(const Question& q) {
  const auto* found = std::find_if(std::begin(kinds), std::end(kinds), [&](const Kind& k) { return q.kind == k.name; });
  if (found == std::end(kinds)) throw std::logic_error("no exact answer about shapes of kind " + q.kind);
  return *found;
}

bool is_usable(const oracle::Ray& ray) {
  const Vec3 &o = ray.origin, &d = ray.direction;
  if (std::isnan(ray.t_min) || std::isnan(ray.t_max)) return false;
  for (const double x : {o.x, o.y, o.z, d.x, d.y, d.z})
    if (!std::isfinite(x)) return false;
  return d != Vec3{};
}

bool is_before(const oracle::Exact& a, const oracle::Exact& b) {
  return a.value < b.value || (a.value == b.value && a.rest < b.rest);
}

/// So close that two correct answers may come out in either order.
bool is_close(const oracle::Exact& a, const oracle::Exact& b) {
  return std::fabs(a.value - b.value) <= 8 * u * std::fmax(std::fabs(a.value), std::fabs(b.value));
}

}  // namespace

int planes_of(const std::string& kind) {
  Question q;
  q.kind = kind;
  return kind_of(q).planes;
}

ExactAnswer exact_answer(const Question& q) {
  const Kind& kind = kind_of(q);
  ExactAnswer nearest;
  if (!is_usable(q.ray)) return nearest;
  bool are_all_promised = true;
  std::vector<oracle::Exact> met;
  const int count = static_cast<int>(q.planes.size()) / kind.planes;
  for (int i = 0; i < count; ++i) {
    ExactAnswer one = kind.ask({q.ray, q.planes.data() + i * kind.planes, i == q.left});
    are_all_promised = are_all_promised && one.is_promised;
    if (one.hit) met.push_back(one.t);
    if (!one.hit || (nearest.hit && !is_before(one.t, nearest.t))) continue;
    nearest = one;
    nearest.primitive = i;
  }
  nearest.is_promised = are_all_promised;
  const auto rival = [&](const oracle::Exact& t) { return is_close(t, nearest.t); };
  nearest.is_alone = std::count_if(met.begin(), met.end(), rival) <= 1;
  return nearest;
}

void answer(Question& q) {
  const ExactAnswer exact = exact_answer(q);
  q.expected = !exact.is_promised ? Expected::either : exact.hit ? Expected::hit : Expected::miss;
  q.primitive = exact.hit && exact.is_alone ? exact.primitive : -1;
  q.t = exact.t;
  q.t_rounding = exact.t_rounding;
}

}  // namespace strahl::selftest
