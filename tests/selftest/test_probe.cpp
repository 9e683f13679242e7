// SPDX-License-Identifier: MIT
// Questions that a device is asked are those that were meant: the robust tier answers with the host's bits, at every
// width, in batches of any size, about many primitives and the one just left.
#include <bit>
#include <catch2/catch.hpp>
#include <cmath>

#include "program/kernel_source.h"
#include "robust/ask_host.h"
#include "selftest/probe.h"
#include "selftest/seams.h"
#include "support/devices.h"

using namespace strahl;
using namespace strahl::selftest;
using namespace strahl::test;

namespace {

std::vector<Question> draw(const std::string& kind, int per_law) {
  std::vector<Question> questions;
  for (const oracle::Law law : oracle::all_laws) {
    oracle::Random random(40 + static_cast<std::uint64_t>(law));
    for (int i = 0; i < per_law; ++i) {
      questions.push_back(draw_question(kind, law, random));
      // From where it stands, the ray may have just left the shape.
      questions.push_back(questions.back());
      questions.back().left = 0;
    }
  }
  return questions;
}

bool same_bits(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

}  // namespace

TEST_CASE("PoCL answers questions with the host's bits in the robust tier") {
  require_pocl();
  const Device device = Device::open("pocl");
  for (const std::string& kind : list_entries("shapes")) {
    const std::vector<Question> questions = draw(kind, 200);
    std::vector<float> expected;
    int hits = 0;
    for (const Question& q : questions) hits += std::isfinite(expected.emplace_back(ask_host(q)));
    CHECK(hits > 600);
    for (const int lanes : {1, 16}) {
      INFO(kind << ", " << lanes << " lanes");
      Probe probe(device, kind, Precision::robust, {lanes, {}});
      CHECK(probe.lanes() == lanes);
      const std::vector<Answer> answers = probe.ask(questions);
      REQUIRE(answers.size() == questions.size());
      int differing = 0;
      for (std::size_t i = 0; i < answers.size(); ++i) {
        const double t = static_cast<double>(expected[i]);
        differing += !same_bits(answers[i].t, t) || answers[i].primitive != (std::isinf(t) ? -1 : 0);
      }
      CHECK(differing == 0);
      CHECK(probe.nanoseconds_per_test() > 0);
    }
  }
}

TEST_CASE("a question may be about many primitives, and a batch larger than a launch") {
  require_pocl();
  Probe probe(Device::open("pocl"), "sphere", Precision::stable);
  // Spheres of radius 1 at x = 3 i, seen along x: with the first k left out by t_min, the one hit is number k.
  constexpr int spheres = 37;
  std::vector<Question> questions;
  for (int i = 0; i < 20000; ++i) {
    Question q;
    q.kind = "sphere";
    for (int k = 0; k < spheres; ++k) q.planes.insert(q.planes.end(), {3.0 * k, 0, 0, 1});
    q.expected = Expected::hit;
    q.primitive = i % spheres;
    q.ray = {{-10, 0, 0}, {2, 0, 0}, (8.5 + 3 * q.primitive) / 2, 1000};
    q.t = {(9 + 3 * q.primitive) / 2.0, 0};
    questions.push_back(q);
  }
  // The sphere that was left is not met where it was left, and the next one is what its ray meets.
  questions.push_back(questions.front());
  questions.back().left = 0;
  questions.back().ray.origin = {1, 0, 0};
  questions.back().ray.t_min = 0;
  questions.back().primitive = 1;
  questions.back().t = {0.5, 0};
  const std::vector<Answer> answers = probe.ask(questions);
  REQUIRE(answers.size() == questions.size());
  int wrong = 0;
  for (std::size_t i = 0; i < answers.size(); ++i) {
    const Judgement judgement = judge(questions[i], answers[i].t, answers[i].primitive);
    wrong += judgement.is_wrong || judgement.ulps > 0;
  }
  CHECK(wrong == 0);
  CHECK(probe.ask({}).empty());
  CHECK_THROWS_AS(Probe(Device::open("pocl"), "disk", Precision::stable).ask(questions), std::logic_error);
}

TEST_CASE("double precision answers to the last place of float") {
  require_pocl();
  Probe probe(Device::open("pocl", {true}), "sphere", Precision::fp64);
  const std::vector<Question> questions = draw("sphere", 500);
  const std::vector<Answer> answers = probe.ask(questions);
  double worst = 0;
  int hits = 0;
  for (std::size_t i = 0; i < answers.size(); ++i) {
    if (questions[i].expected != Expected::hit || questions[i].left >= 0) continue;
    const Judgement judgement = judge(questions[i], answers[i].t, answers[i].primitive);
    CHECK_FALSE(judgement.is_wrong);
    worst = std::max(worst, judgement.ulps);
    ++hits;
  }
  CHECK(hits > 1000);
  CHECK(worst <= 0.01);
}

TEST_CASE("a change of the program reaches the device") {
  require_pocl();
  ProbeOptions options;
  options.change = [](ProgramSource& source) {
    const std::string reported = "ray_given_t(&ray, best.t, in[RAY_T_MIN], in[RAY_T_MAX])";
    const std::size_t at = source.text.find(reported);
    REQUIRE(at != std::string::npos);
    source.text.replace(at, reported.size(), "R(7.0)");
  };
  Probe probe(Device::open("pocl"), "sphere", Precision::stable, options);
  Question q;
  q.kind = "sphere";
  q.planes = {0, 0, 0, 1};
  q.ray = {{-10, 0, 0}, {1, 0, 0}, 0, 1000};
  CHECK(probe.ask({&q, 1}).front().t == 7);
}

TEST_CASE("seams: where nothing is left to be hit, an answer that is no number is wrong") {
  require_pocl();
  const std::vector<ClosedSurface> surfaces = surfaces_of("triangle");
  REQUIRE_FALSE(surfaces.empty());
  for (const bool is_faulty : {false, true}) {
    ProbeOptions options;
    if (is_faulty)
      options.change = [](ProgramSource& source) {
        const std::string miss = "best.kind < 0 ? infinite :";
        const std::size_t at = source.text.find(miss);
        REQUIRE(at != std::string::npos);
        source.text.replace(at, miss.size(), "best.kind < 0 ? infinite - infinite :");
      };
    Probe probe(Device::open("pocl"), "triangle", Precision::robust, options);
    Seams seams;
    ask_seams(probe, "triangle", surfaces.front(), 100, 1, seams);
    CHECK(seams.rays == 100);
    CHECK(seams.leaks == 0);
    CHECK(seams.doubles == (is_faulty ? 100 : 0));
  }
}
