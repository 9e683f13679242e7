// SPDX-License-Identifier: MIT
// The planes that a shape's proof asks about are those that the host packs: what it says a scene has of them, packed,
// is met where they are.
#include <catch2/catch.hpp>
#include <cmath>

#include "packing/pack_shapes.h"
#include "program/kernel_source.h"
#include "selftest/questions.h"
#include "selftest/shape_proof.h"

using namespace strahl;
using namespace strahl::selftest;

namespace {

Question packed_again(Question q) {
  const Geometry geometry = proof_of(q.kind).geometry(q.planes.data());
  q.planes.clear();
  primitive_planes(geometry, UploadFrame{}, [&](std::span<const double> planes) {
    for (const double x : planes) q.planes.push_back(to_float(x));
  });
  return q;
}

}  // namespace

TEST_CASE("a proof's geometry has the planes that it asks about") {
  constexpr int cases = 1000;
  for (const std::string& kind : list_entries("shapes")) {
    INFO(kind);
    oracle::Random random(5);
    int met = 0, elsewhere = 0;
    for (int i = 0; i < cases; ++i) {
      const Question q = draw_question(kind, oracle::Law::aimed, random);
      if (q.expected != Expected::hit) continue;
      const Question again = packed_again(q);
      REQUIRE(again.planes.size() == q.planes.size());
      const ExactAnswer answer = exact_answer(again);
      ++met;
      elsewhere += !answer.hit || std::fabs(answer.t.value - q.t.value) > 1e-3 * std::fabs(q.t.value);
    }
    CHECK(met > cases / 4);
    // Where a ray grazes, what packing rounds decides.
    CHECK(elsewhere <= cases / 100);
  }
}
