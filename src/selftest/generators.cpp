// SPDX-License-Identifier: MIT
#include "selftest/generators.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "errors.h"
#include "selftest/answer.h"
#include "selftest/shape_proof.h"

namespace strahl::selftest {

double Draft::size(const std::string& name, double usual) {
  used_.insert(name);
  const auto found = sizes_.find(name);
  return found == sizes_.end() ? usual : found->second;
}

Vec3 Draft::direction() {
  for (;;) {
    const Vec3 v{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    const double squared = dot(v, v);
    if (squared > 0.01 && squared <= 1) return normalized(v);
  }
}

Vec3 Draft::perpendicular(const Vec3& n) {
  for (;;) {
    const Vec3 across = cross(n, direction());
    if (length(across) > 0.1) return normalized(across);
  }
}

Vec3 Draft::place() { return to_float(size("offset", 0) * direction()); }

std::vector<std::string> Draft::unused() const {
  std::vector<std::string> names;
  for (const auto& [name, value] : sizes_)
    if (used_.count(name) == 0) names.push_back(name);
  return names;
}

Question question_about(const char* kind) {
  Question q;
  q.kind = kind;
  return q;
}

void put(Question& q, double x) { q.planes.push_back(to_float(x)); }

void put(Question& q, const Vec3& v) {
  for (const double x : {v.x, v.y, v.z}) put(q, x);
}

void aim(Question& q, const Vec3& origin, const Vec3& direction) {
  q.ray.origin = to_float(origin);
  q.ray.direction = to_float(direction);
}

namespace {

std::optional<Generator> find(const std::string& name) {
  for (const ShapeProof* proof : all_proofs())
    for (const Generator& generator : proof->generators())
      if (name == generator.name) return generator;
  return std::nullopt;
}

}  // namespace

bool is_generator(const std::string& name) { return find(name).has_value(); }

std::vector<Question> generate(const Generated& call) {
  const std::optional<Generator> generator = find(call.generator);
  if (!generator) throw InputError(fmt::format("there is no generator \"{}\"", call.generator));
  Draft draft(call);
  std::vector<Question> questions;
  for (; draft.index < call.count; ++draft.index) {
    Question q = generator->draw(draft);
    answer(q);
    if (generator->surface != Surface::open && q.expected != Expected::hit) {
      if (q.primitive < 0 && !exact_answer(q).hit)
        throw InputError(fmt::format("{} does not close around the origin", call.generator));
      q.expected = Expected::hit;
      q.primitive = -1;
      if (generator->surface == Surface::closed) q.t_rounding = INFINITY;
    }
    questions.push_back(std::move(q));
  }
  if (const auto unused = draft.unused(); !unused.empty() && call.count > 0)
    throw InputError(fmt::format("the generator \"{}\" has no size \"{}\"", call.generator, unused[0]));
  return questions;
}

}  // namespace strahl::selftest
