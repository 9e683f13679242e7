// SPDX-License-Identifier: MIT
// What a ray leaves is not met again, and what lies close over it is: a copy of the primitive, 4 times further out than
// a renderer may displace the ray's origin (4 ulp of its largest coordinate + 4 u of the primitive's size), is hit by
// every ray that the exact answer says meets it. In the robust tier, on a device.
//
// STRAHL_CASES: cases a kind instead of 40,000. STRAHL_DEVICE: another device than PoCL.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <iostream>
#include <optional>

#include "campaign/progress.h"
#include "program/kernel_source.h"
#include "selftest/answer.h"
#include "selftest/probe.h"
#include "selftest/questions.h"
#include "selftest/tally.h"
#include "selftest/to_float.h"
#include "support/devices.h"

using namespace strahl;
using namespace strahl::selftest;
using oracle::Law;

namespace {

Vec3 at(const Question& q, std::size_t i) { return {q.planes[i], q.planes[i + 1], q.planes[i + 2]}; }

double largest(const Vec3& v) { return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)}); }

/// Unit, away from the primitive at p.
Vec3 normal_at(const Question& q, const Vec3& p) {
  if (q.kind == "sphere") return normalized(p - at(q, 0));
  if (q.kind == "cylinder") return normalized(p - at(q, 0) - dot(p - at(q, 0), at(q, 3)) * at(q, 3));
  if (q.kind == "plane" || q.kind == "disk") return normalized(at(q, 3));
  return normalized(cross(at(q, 3) - at(q, 0), at(q, q.kind == "triangle" ? 6 : 9) - at(q, 0)));
}

double size_of(const Question& q) {
  if (q.kind == "sphere") return q.planes[3];
  if (q.kind == "cylinder") return std::max(q.planes[6], q.planes[7]);
  if (q.kind == "disk") return std::sqrt(q.planes[6]);
  if (q.kind == "plane") return 0;
  return std::max(length(at(q, 3) - at(q, 0)), length(at(q, 6) - at(q, 3)));
}

/// The primitive, `gap` further out along n; round ones grow by it.
std::vector<double> lifted(const Question& q, const Vec3& n, double gap) {
  std::vector<double> planes = q.planes;
  if (q.kind == "sphere" || q.kind == "cylinder") {
    planes.back() = to_float(planes.back() + gap);
    return planes;
  }
  const std::size_t points = q.kind == "triangle" ? 9 : q.kind == "parallelogram" ? 12 : 3;
  for (std::size_t i = 0; i < points; i += 3) {
    const Vec3 p = to_float(at(q, i) + gap * n);
    planes[i] = p.x, planes[i + 1] = p.y, planes[i + 2] = p.z;
  }
  return planes;
}

/// A ray that has left the question's primitive where it was hit, and the copy over it; none where the exact answer is
/// not that the copy is met.
std::optional<Question> over(const Question& question, oracle::Random& random) {
  Question q = question;
  q.ray.origin = to_float(question.ray.origin + question.t.value * question.ray.direction);
  const Vec3 n =
      (random.integer(0, 1) == 0 || q.kind == "sphere" || q.kind == "cylinder" ? 1 : -1) * normal_at(q, q.ray.origin);
  const double bound = 4 * 0x1p-23 * largest(q.ray.origin) + 4 * u * size_of(q);
  const Vec3 aside{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
  // Grazing to 10^-7 where the copy has no end.
  const double steep = q.kind == "plane" && random.integer(0, 1) == 0 ? std::fabs(random.log_uniform(-7, 0)) : 1;
  q.ray.direction = to_float(steep * n + 0.5 * (aside - dot(aside, n) * n));
  q.ray.t_min = 0;
  q.ray.t_max = INFINITY;
  q.planes = lifted(q, n, 4 * bound);
  q.left = -1;
  answer(q);
  if (q.expected != Expected::hit) return std::nullopt;
  q.planes.insert(q.planes.begin(), question.planes.begin(), question.planes.end());
  q.left = 0;
  q.primitive = 1;
  return q;
}

}  // namespace

TEST_CASE("the copy over what was left is met") {
  test::require_pocl_and_rusticl();
  const Device device = Device::open(test::device_asked_for());
  const auto wanted = static_cast<std::size_t>(test::count_asked_for("STRAHL_CASES", 40000));
  for (const std::string& kind : list_entries("shapes")) {
    if (kind == "box") continue;  // normal_at knows none of a box.
    Probe probe(device, kind, Precision::robust);
    Tally tally;
    std::size_t drawn = 0;
    for (std::uint64_t seed = 0; tally.cases < wanted; ++seed) {
      oracle::Random random(seed);
      std::vector<Question> questions;
      for (int i = 0; i < 20000; ++i) {
        const Question first = draw_question(kind, i % 2 == 0 ? Law::aimed : Law::offset, random);
        if (first.expected != Expected::hit) continue;
        ++drawn;
        if (auto q = over(first, random)) questions.push_back(*std::move(q));
      }
      const std::vector<Answer> answers = probe.ask(questions);
      for (std::size_t i = 0; i < questions.size(); ++i) tally.add(questions[i], answers[i]);
    }
    std::cout << kind << ": " << tally.cases << " of " << drawn << " asked, " << tally.wrong << " wrong" << std::endl;
    INFO(kind << ": " << tally.first_wrong);
    CHECK(tally.wrong == 0);
    CHECK(2 * tally.cases > drawn);
  }
}
