// SPDX-License-Identifier: MIT
// One function a kind of shape; what is promised of the answers stands in answer.cpp.
#include "selftest/questions.h"

#include <algorithm>
#include <stdexcept>

#include "selftest/answer.h"

namespace strahl::selftest {

void put(std::vector<double>& planes, const Vec3& v) {
  for (const double x : {v.x, v.y, v.z}) planes.push_back(to_float(x));
}

void settle(Question& q, const oracle::Answer& answer, bool is_outside_band) {
  const bool is_decided = is_outside_band && answer.range_margin >= 4 * u;
  q.expected = !is_decided ? Expected::either : answer.hit ? Expected::hit : Expected::miss;
  q.primitive = answer.hit ? 0 : -1;
  q.t = answer.t;
}

namespace {

using oracle::Law;

Question question(const char* kind, const oracle::Ray& ray) {
  Question q;
  q.kind = kind;
  q.ray = ray;
  return q;
}

Question sphere_question(oracle::Random& random, Law law) {
  const auto drawn = oracle::sphere_case(random, law, oracle::Rounding::to_float);
  Question q = question("sphere", drawn.ray);
  put(q.planes, drawn.shape.center);
  q.planes.push_back(to_float(drawn.shape.radius));
  return q;
}

/// The axis is what the device holds: a unit vector, rounded, times the length, rounded.
Question cylinder_question(oracle::Random& random, Law law) {
  const auto drawn = oracle::cylinder_case(random, law, oracle::Rounding::to_float);
  Question q = question("cylinder", drawn.ray);
  put(q.planes, drawn.shape.p0);
  put(q.planes, normalized(drawn.shape.axis));
  q.planes.push_back(to_float(length(drawn.shape.axis)));
  q.planes.push_back(to_float(drawn.shape.radius));
  return q;
}

Question plane_question(oracle::Random& random, Law law) {
  const auto drawn = oracle::plane_case(random, law, oracle::Rounding::to_float);
  Question q = question("plane", drawn.ray);
  put(q.planes, drawn.shape.point);
  put(q.planes, drawn.shape.normal);
  return q;
}

Question disk_question(oracle::Random& random, Law law) {
  const auto drawn = oracle::disk_case(random, law, oracle::Rounding::to_float);
  Question q = question("disk", drawn.ray);
  put(q.planes, drawn.shape.center);
  put(q.planes, cross(drawn.shape.axis_u, drawn.shape.axis_v));
  q.planes.push_back(to_float(dot(drawn.shape.axis_u, drawn.shape.axis_u)));
  return q;
}

Question box_question(oracle::Random& random, Law law) {
  const auto drawn = oracle::aabb_case(random, law, oracle::Rounding::to_float);
  const oracle::Aabb& s = drawn.shape;
  Question q = question("box", drawn.ray);
  for (const double x : {s.min.x, s.max.x, s.min.y, s.max.y, s.min.z, s.max.z}) q.planes.push_back(to_float(x));
  return q;
}

Question triangle_question(oracle::Random& random, Law law) {
  const auto drawn = oracle::triangle_case(random, law, oracle::Rounding::to_float);
  Question q = question("triangle", drawn.ray);
  for (const Vec3& p : {drawn.shape.p0, drawn.shape.p1, drawn.shape.p2}) put(q.planes, p);
  return q;
}

/// Four corners are packed, each rounded.
Question parallelogram_question(oracle::Random& random, Law law) {
  const auto drawn = oracle::parallelogram_case(random, law, oracle::Rounding::to_float);
  const oracle::Parallelogram& given = drawn.shape;
  Question q = question("parallelogram", drawn.ray);
  put(q.planes, given.corner);
  put(q.planes, given.corner + given.edge_u);
  put(q.planes, given.corner + given.edge_u + given.edge_v);
  put(q.planes, given.corner + given.edge_v);
  return q;
}

}  // namespace

Question draw_question(const std::string& kind, Law law, oracle::Random& random) {
  struct Kind {
    const char* name;
    Question (*draw)(oracle::Random&, Law);
  };
  static constexpr Kind kinds[] = {
#define SHAPE(name, planes) {#name, name##_question},
#include "../../cl/shapes/shapes.def"
#undef SHAPE
  };
  const auto* found = std::find_if(std::begin(kinds), std::end(kinds), [&](const Kind& k) { return kind == k.name; });
  if (found == std::end(kinds)) throw std::logic_error("no questions are drawn about shapes of kind " + kind);
  Question q = found->draw(random, law);
  answer(q);
  return q;
}

}  // namespace strahl::selftest
