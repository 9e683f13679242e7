// SPDX-License-Identifier: MIT
// The exact answers hold for the place as it was rounded, whether or not that is on the surface. long double: f . d
// keeps 2^-40 of |f| |d| and more where it cancels.
#include "selftest/respawn.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "oracle/number.h"
#include "selftest/questions.h"

namespace strahl::selftest {
namespace {

using Long = oracle::Vector<long double>;

Vec3 at(const Question& q, std::size_t i) { return {q.planes[i], q.planes[i + 1], q.planes[i + 2]}; }

Vec3 any_direction(oracle::Random& random) {
  for (;;) {
    const Vec3 v{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    if (length(v) > 0.1 && length(v) <= 1) return normalized(v);
  }
}

/// Some normal of the surface at p, of any length; of a flat shape its own.
Vec3 normal_at(const Question& q, const Vec3& p) {
  if (q.kind == "sphere") return p - at(q, 0);
  if (q.kind == "cylinder") return p - at(q, 0) - dot(p - at(q, 0), at(q, 3)) * at(q, 3);
  if (q.kind == "plane" || q.kind == "disk") return at(q, 3);
  if (q.kind == "box") return {1, 0, 0};
  return cross(at(q, 3) - at(q, 0), at(q, q.kind == "triangle" ? 6 : 9) - at(q, 0));
}

void expect(Question& q, long double t) {
  q.expected = t > 0 ? Expected::hit : Expected::miss;
  q.primitive = t > 0 ? 0 : -1;
  q.t.value = static_cast<double>(t);
  q.t.rest = static_cast<double>(t - static_cast<long double>(q.t.value));
}

/// How much of |f| |d| may be lost of f . d: the stable forms round f and each product.
double doubt(Precision precision) { return precision == Precision::robust ? 0x1p-40 : 0x1p-18; }

void expect_of_sphere(Question& q, Precision precision) {
  const Long f = Long(q.ray.origin) - Long(at(q, 0)), d(q.ray.direction);
  const long double along = dot(f, d);
  if (std::fabs(along) > doubt(precision) * std::sqrt(dot(f, f) * dot(d, d))) expect(q, -2 * along / dot(d, d));
}

/// Where the other root is clear of the mantle's ends.
void expect_of_cylinder(Question& q, Precision precision) {
  const Long f = Long(q.ray.origin) - Long(at(q, 0)), d(q.ray.direction), v(at(q, 3));
  const Long from = cross(f, v), across = cross(d, v);
  const long double inner = dot(from, across), a = dot(across, across);
  if (!(a > 0x1p-20L * dot(d, d) * dot(v, v))) return;
  if (!(std::fabs(inner) > doubt(precision) * std::sqrt(dot(f, f) * dot(d, d)) * dot(v, v))) return;
  const long double other = -2 * inner / a;
  const long double place = dot(f + other * d, v) / (static_cast<long double>(q.planes[6]) * dot(v, v));
  if (other > 0 && std::fabs(place - 0.5L) > 0.49L && std::fabs(place - 0.5L) < 0.51L) return;
  const bool is_met = other > 0 && std::fabs(place - 0.5L) < 0.5L;
  expect(q, is_met ? other : -1);
  q.t_rounding = static_cast<double>(32 * u * u * std::sqrt(dot(from, from) / a));
}

/// The face that was left is the nearest one; none is where two are about as near.
void expect_of_box(Question& q) {
  const Vec3 &o = q.ray.origin, &d = q.ray.direction;
  const std::array origin{o.x, o.y, o.z}, along{d.x, d.y, d.z};
  std::array<double, 6> away{};
  for (std::size_t i = 0; i < 6; ++i) away[i] = std::fabs(q.planes[i] - origin[i / 2]);
  const std::size_t nearest = static_cast<std::size_t>(std::min_element(away.begin(), away.end()) - away.begin());
  const double size = std::max({std::fabs(o.x), std::fabs(o.y), std::fabs(o.z)});
  for (std::size_t i = 0; i < 6; ++i)
    if (i != nearest && away[i] <= away[nearest] + 64 * u * size) return;
  const double inward = nearest % 2 == 0 ? along[nearest / 2] : -along[nearest / 2];
  if (inward <= 0) return expect(q, -1);
  oracle::Ray line = q.ray;
  line.t_min = -INFINITY;
  const auto answer =
      oracle::aabb(line, {{q.planes[0], q.planes[2], q.planes[4]}, {q.planes[1], q.planes[3], q.planes[5]}});
  if (!answer.line_meets || std::fabs(answer.margin) < 4 * u || !(answer.exit.value > 0)) return;
  q.expected = Expected::hit;
  q.primitive = 0;
  q.t = answer.exit;
}

}  // namespace

std::optional<Question> respawned(const Question& question, const Answer& answer, Precision precision,
                                  oracle::Random& random) {
  if (!std::isfinite(answer.t)) return std::nullopt;
  Question q;
  q.kind = question.kind;
  q.planes = question.planes;
  q.left = 0;
  q.ray.origin = to_float(question.ray.origin + answer.t * question.ray.direction);
  const Vec3 normal = normal_at(q, q.ray.origin);
  q.ray.direction = to_float(any_direction(random));
  const double tilt = random.log_uniform(-7, -1);
  if (random.integer(0, 3) == 0) {
    const Vec3 tangent = cross(normalized(normal), any_direction(random));
    q.ray.direction = to_float(normalized(tangent) + tilt * normalized(normal));
  }
  const double reach = length(q.ray.origin) * length(q.ray.direction) * length(normal);
  if (!(reach < 1e30) || !(length(normal) > 1e-30)) return std::nullopt;
  // The textbook knows no primitive that was left; it leaves by a distance (cl/hits/epsilon_fast.h).
  if (precision == Precision::fast) q.ray.t_min = to_float(1e-4 / length(q.ray.direction));
  if (q.kind == "sphere")
    expect_of_sphere(q, precision);
  else if (q.kind == "cylinder")
    expect_of_cylinder(q, precision);
  else if (q.kind == "box")
    expect_of_box(q);
  else
    q.expected = Expected::miss;
  return q;
}

}  // namespace strahl::selftest
