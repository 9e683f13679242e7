// SPDX-License-Identifier: MIT
// Large numbers of drawn questions about one kind of shape, on a device, in every tier that promises something: the
// answers have the bits of the same bodies compiled on the host; in robust and double no hit or miss is wrong outside
// the bands of selftest/shapes/, t is within the stated ulps of float, and no ray meets again what it leaves.
//
// STRAHL_CASES: cases for each of the eight laws, where the number below is too small. More: campaign/progress.h.
#include <array>
#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <iostream>

#include "campaign/progress.h"
#include "selftest/nearest.h"
#include "selftest/probe.h"
#include "selftest/questions.h"
#include "selftest/respawn.h"
#include "selftest/shape_proof.h"
#include "selftest/tally.h"
#include "support/devices.h"

using namespace strahl;
using namespace strahl::selftest;
using oracle::Law;

namespace {

constexpr int chunk = 25000;

struct Count {
  std::uint64_t cases = 0, decided = 0, hits = 0, wrong = 0, nans = 0, compared = 0, other_bits = 0;
  double robust_ulps = 0, double_ulps = 0;
  std::uint64_t left = 0, met_again = 0;

  void add(const Count& c) {
    cases += c.cases, decided += c.decided, hits += c.hits, wrong += c.wrong, nans += c.nans;
    compared += c.compared, other_bits += c.other_bits, left += c.left, met_again += c.met_again;
    robust_ulps = std::max(robust_ulps, c.robust_ulps);
    double_ulps = std::max(double_ulps, c.double_ulps);
  }
  friend std::ostream& operator<<(std::ostream& out, const Count& c) {
    return out << c.cases << ' ' << c.decided << ' ' << c.hits << ' ' << c.wrong << ' ' << c.nans << ' ' << c.compared
               << ' ' << c.other_bits << ' ' << c.robust_ulps << ' ' << c.double_ulps << ' ' << c.left << ' '
               << c.met_again;
  }
  friend std::istream& operator>>(std::istream& in, Count& c) {
    return in >> c.cases >> c.decided >> c.hits >> c.wrong >> c.nans >> c.compared >> c.other_bits >> c.robust_ulps >>
           c.double_ulps >> c.left >> c.met_again;
  }
};

using Host = test::Nearest (*)(std::string_view, std::span<const double>, std::span<const double>, int);

class Campaign {
 public:
  Campaign(const std::string& kind, double robust_ulps)
      : kind_(kind), robust_ulps_(robust_ulps), device_(Device::open(test::device_asked_for())) {
    tiers_.push_back({Precision::stable, test::nearest_stable, Probe(device_, kind, Precision::stable)});
    tiers_.push_back({Precision::robust, test::nearest_robust, Probe(device_, kind, Precision::robust)});
    if (device_.info().fp64)
      tiers_.push_back({Precision::fp64, test::nearest_double, Probe(device_, kind, Precision::fp64)});
  }

  /// per_law cases a law. The first million of all of them in every tier, against the host's bits too, with rays that
  /// leave what was hit; the others in robust, and double for spheres.
  void run(int per_law) {
    Count total;
    for (const Law law : oracle::all_laws) {
      if (law == Law::extreme) continue;  // Its products leave the range of float.
      for (int first = 0, number = 0; first < per_law; first += chunk, ++number) {
        const std::string name = kind_ + "/" + std::to_string(static_cast<int>(law)) + "/" + std::to_string(number);
        const Count* known = progress_.find(name);
        const Count count = known ? *known : ask(law, static_cast<std::uint64_t>(number), first < 125000);
        if (!known) progress_.finished(name, count);
        total.add(count);
      }
    }
    std::cout << kind_ << ": " << total.cases << " cases, " << total.decided << " decided, " << total.hits << " hits, "
              << total.wrong << " wrong, " << total.nans << " NaN, largest error robust " << total.robust_ulps
              << " ulp, double " << total.double_ulps << " ulp of float; " << total.left << " left, " << total.met_again
              << " wrong after it; " << total.compared << " compared with the host, " << total.other_bits
              << " with other bits" << std::endl;
    CHECK(total.wrong == 0);
    CHECK(total.nans == 0);
    CHECK(total.other_bits == 0);
    CHECK(total.met_again == 0);
    CHECK(total.robust_ulps <= robust_ulps_);
    CHECK(total.double_ulps <= 1);
    CHECK(4 * total.hits > total.cases);
    CHECK(4 * total.left > std::min<std::uint64_t>(1000000, total.cases));
    CHECK(total.compared >= std::min<std::uint64_t>(1000000, total.cases));
  }

 private:
  struct Tier {
    Precision precision;
    Host host;
    Probe probe;
  };

  static bool same_bits(double a, double b) {
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
  }

  Count ask(Law law, std::uint64_t number, bool is_thorough) {
    oracle::Random random(1000 + 16 * number + static_cast<std::uint64_t>(law));
    std::vector<Question> questions;
    for (int i = 0; i < chunk; ++i) questions.push_back(draw_question(kind_, law, random));
    Count count;
    count.cases = questions.size();
    for (const Question& q : questions) {
      count.decided += q.expected != Expected::either;
      count.hits += q.expected == Expected::hit;
    }
    for (Tier& tier : tiers_) {
      const bool is_needed =
          tier.precision == Precision::robust || (tier.precision == Precision::fp64 && kind_ == "sphere");
      if (!is_thorough && !is_needed) continue;
      const std::vector<Answer> answers = tier.probe.ask(questions);
      if (is_thorough) compare(tier, questions, answers, count);
      if (tier.precision == Precision::stable) continue;
      judge_all(tier, questions, answers, count);
      if (is_thorough || is_long_) leave(tier, questions, answers, random, count);
    }
    return count;
  }

  void compare(const Tier& tier, const std::vector<Question>& questions, const std::vector<Answer>& answers,
               Count& count) const {
    for (std::size_t i = 0; i < questions.size(); ++i) {
      const oracle::Ray& r = questions[i].ray;
      const std::array<double, 8> ray{r.origin.x,    r.origin.y,    r.origin.z, r.direction.x,
                                      r.direction.y, r.direction.z, r.t_min,    r.t_max};
      const test::Nearest host = tier.host(kind_, questions[i].planes, ray, questions[i].left);
      ++count.compared;
      count.other_bits += !same_bits(host.t, answers[i].t) || host.primitive != answers[i].primitive;
      count.nans += std::isnan(answers[i].t);
    }
  }

  void judge_all(const Tier& tier, const std::vector<Question>& questions, const std::vector<Answer>& answers,
                 Count& count) const {
    double& worst = tier.precision == Precision::robust ? count.robust_ulps : count.double_ulps;
    for (std::size_t i = 0; i < questions.size(); ++i) {
      const Judgement judgement = judge(questions[i], answers[i].t, answers[i].primitive);
      count.nans += judgement.is_nan;
      worst = std::max(worst, judgement.ulps);
      if (judgement.is_wrong && ++count.wrong < 4)
        UNSCOPED_INFO(precision_name(tier.precision) << ": " << text_of(questions[i], answers[i]));
    }
  }

  /// Rays that leave what was hit.
  void leave(Tier& tier, const std::vector<Question>& questions, const std::vector<Answer>& answers,
             oracle::Random& random, Count& count) const {
    std::vector<Question> second;
    for (std::size_t i = 0; i < questions.size(); ++i)
      if (auto q = respawned(questions[i], answers[i], tier.precision, random)) second.push_back(*std::move(q));
    const std::vector<Answer> found = tier.probe.ask(second);
    count.left += second.size();
    for (std::size_t i = 0; i < second.size(); ++i) {
      const Judgement judgement = judge(second[i], found[i].t, found[i].primitive);
      if (judgement.is_wrong && ++count.met_again < 4)
        UNSCOPED_INFO("left in " << precision_name(tier.precision) << ": " << text_of(second[i], found[i]));
    }
  }

  std::string kind_;
  double robust_ulps_;
  bool is_long_ = std::getenv("STRAHL_CASES") != nullptr;
  Device device_;
  std::vector<Tier> tiers_;
  test::Progress<Count> progress_;
};

/// How many a law: 350,000 of a kind.
constexpr int usual_count = 50000;

/// Of t, in the robust tier. So far boxes keep half an ulp more than they promise.
double ulps_of(const std::string& kind) { return kind == "box" ? 1.5 : proof_of(kind).promises().robust_ulps; }

void hold(const std::string& kind) {
  test::require_pocl_and_rusticl();
  Campaign(kind, ulps_of(kind)).run(static_cast<int>(test::count_asked_for("STRAHL_CASES", usual_count)));
}

}  // namespace

// A case a kind, by its name (campaign/tests.cmake).
#define SHAPE(name, planes) \
  TEST_CASE(#name) { hold(#name); }
#include "../../cl/shapes/shapes.def"
#undef SHAPE
