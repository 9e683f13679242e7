// SPDX-License-Identifier: MIT
// The exact answers hold for the place as it was rounded, whether or not that is on the surface.
#include "selftest/respawn.h"

#include <cmath>

#include "selftest/shape_proof.h"
#include "selftest/to_float.h"

namespace strahl::selftest {
namespace {

Vec3 any_direction(oracle::Random& random) {
  for (;;) {
    const Vec3 v{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    if (length(v) > 0.1 && length(v) <= 1) return normalized(v);
  }
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
  const ShapeProof& proof = proof_of(q.kind);
  const Vec3 normal = proof.normal(q.planes.data(), q.ray.origin);
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
  proof.expect_leaving(q, precision);
  return q;
}

}  // namespace strahl::selftest
