// SPDX-License-Identifier: MIT
// Kind by kind, so that questions are drawn once for all tiers and then forgotten.
#include "selftest/selftest.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>

#include "program/kernel_source.h"
#include "selftest/answer.h"
#include "selftest/catalogue.h"
#include "selftest/faults.h"
#include "selftest/promise.h"
#include "selftest/questions.h"
#include "selftest/respawn.h"
#include "stopwatch.h"

namespace strahl::selftest {
namespace {

using oracle::Law;

constexpr std::size_t rays_per_surface = 2000;

const char* law_name(Law law) {
  static constexpr std::array names{"aimed",         "log_uniform", "border",       "exact_border", "in_surface",
                                    "axis_parallel", "offset",      "unnormalised", "extreme"};
  static_assert(names.size() == oracle::all_laws.size());
  return names[static_cast<std::size_t>(law)];
}

bool leaves_range(Precision precision, Law law) { return law == Law::extreme && precision != Precision::fp64; }

class Selftest {
 public:
  Selftest(const Device& device, const SelftestOptions& options, const Step& step)
      : device_(device), step_(step), fault_(options.fault) {
    result_.device = device.info().text();
    result_.options = options;
    if (result_.options.kinds.empty()) result_.options.kinds = list_entries("shapes");
  }

  SelftestResult run() {
    const Stopwatch watch;
    total_ =
        options().tiers.size() + options().kinds.size() * options().tiers.size() * static_cast<std::size_t>(rounds());
    for (const Precision precision : options().tiers) ask_canary(precision);
    const bool is_any_sound = std::any_of(result_.tiers.begin(), result_.tiers.end(), [](const TierResult& tier) {
      return tier.canary.tier.verdict != Verdict::refused;
    });
    if (is_any_sound) {
      sort_catalogue();
      for (const std::string& kind : options().kinds) ask_about(kind);
    }
    fault_.require_injected();
    for (TierResult& tier : result_.tiers) conclude(tier);
    result_.seconds = watch.seconds();
    return std::move(result_);
  }

 private:
  [[nodiscard]] const SelftestOptions& options() const { return result_.options; }
  [[nodiscard]] int rounds() const { return std::max(1, options().rounds); }
  [[nodiscard]] std::function<void(ProgramSource&)> change() {
    return [this](ProgramSource& source) { fault_.inject(source); };
  }

  void tell(const std::string& what) {
    if (step_) step_(static_cast<double>(done_) / static_cast<double>(total_), what);
    ++done_;
  }

  void ask_canary(Precision precision) {
    tell(fmt::format("canary of {}", precision_name(precision)));
    TierResult tier;
    tier.canary = run_canary(device_, precision, {{}, change()});
    tier.tier = tier.canary.tier;
    result_.tiers.push_back(std::move(tier));
  }

  void sort_catalogue() {
    for (const Row& row : catalogue())
      for (Question& question : questions_of(row, options().cases_per_generator)) {
        auto& [rows, questions] = catalogue_of_[question.kind];
        rows.push_back(&row);
        questions.push_back(std::move(question));
      }
  }

  /// One tier's part of what is asked about a kind.
  struct Asked {
    TierResult& tier;
    Probe probe;
    Line line;

    [[nodiscard]] Precision precision() const { return tier.tier.precision; }
  };

  void ask_about(const std::string& kind) {
    std::vector<Asked> all;
    for (TierResult& tier : result_.tiers) {
      if (tier.canary.tier.verdict == Verdict::refused) continue;
      const Precision precision = tier.tier.precision;
      all.push_back({tier,
                     Probe(device_, kind, precision, {{}, change(), tier.tier.loop_turns.has_value()}),
                     {precision, kind, {}, {}, {}, {}, 0}});
    }
    ask_catalogue(all, kind);
    const std::vector<ClosedSurface> surfaces = surfaces_of(kind);
    for (int round = 0; round < rounds(); ++round) {
      const auto seed = [&](std::uint64_t of) {
        return (options().seed * 1000003 + static_cast<std::uint64_t>(round)) * 64 + of;
      };
      std::map<Law, std::vector<Question>> drawn;
      for (const Law law : oracle::all_laws) {
        oracle::Random random(seed(static_cast<std::uint64_t>(law)));
        for (int i = 0; i < options().cases_per_law; ++i) drawn[law].push_back(draw_question(kind, law, random));
      }
      for (Asked& asked : all) {
        tell(fmt::format("{} · {}", precision_name(asked.precision()), kind));
        oracle::Random random(seed(32));
        for (auto& [law, questions] : drawn) ask_law(asked, law, questions, random);
        for (const ClosedSurface& surface : surfaces)
          ask_seams(asked.probe, kind, surface, rays_per_surface, seed(33), asked.line.seams);
      }
    }
    for (Asked& asked : all) finish(asked);
  }

  void ask_catalogue(std::vector<Asked>& all, const std::string& kind) {
    const auto& [rows, questions] = catalogue_of_[kind];
    for (Asked& asked : all) {
      const Promise promise = promise_of_catalogue(asked.precision(), kind);
      const std::vector<Answer> answers = asked.probe.ask(questions);
      std::map<const Row*, Tally> by_row;
      for (std::size_t i = 0; i < questions.size(); ++i) by_row[rows[i]].add(questions[i], answers[i]);
      for (const auto& [row, tally] : by_row) {
        check(asked, fmt::format("[{}] {}", row->id, row->title), tally, promise);
        asked.line.catalogue.add(tally);
      }
    }
  }

  void ask_law(Asked& asked, Law law, const std::vector<Question>& questions, oracle::Random& random) {
    const std::vector<Answer> answers = asked.probe.ask(questions);
    const Promise promise = promise_of(asked.precision(), asked.line.kind, law);
    Tally tally;
    std::vector<Question> leaving;
    for (std::size_t i = 0; i < questions.size(); ++i) {
      const bool is_left_open = leaves_range(asked.precision(), law);
      if (is_left_open) {
        tally.nans += std::isnan(answers[i].t);
        continue;
      }
      tally.add(questions[i], answers[i]);
      if (questions[i].expected != Expected::hit) continue;
      if (auto next = respawned(questions[i], answers[i], asked.precision(), random))
        leaving.push_back(std::move(*next));
    }
    const std::vector<Answer> left = asked.probe.ask(leaving);
    for (std::size_t i = 0; i < leaving.size(); ++i) asked.line.respawn.add(leaving[i], left[i]);

    check(asked, fmt::format("{}, law {}", asked.line.kind, law_name(law)), tally, promise);
    asked.line.laws.add(tally);
  }

  static void check(Asked& asked, const std::string& what, const Tally& tally, const Promise& promise) {
    auto& broken = asked.tier.broken;
    if (promise.none_wrong && tally.wrong > 0)
      broken.push_back(
          fmt::format("{}: {} of {} are wrong, the first: {}", what, tally.wrong, tally.cases, tally.first_wrong));
    if (tally.max_ulps() > promise.ulps)
      broken.push_back(fmt::format("{}: t is {:.3g} ulp off, {:g} are promised", what, tally.max_ulps(), promise.ulps));
    // Whatever is promised otherwise.
    if (tally.nans > 0 && !promise.none_wrong && asked.precision() != Precision::fast)
      broken.push_back(fmt::format("{}: {} answers are no number", what, tally.nans));
  }

  void finish(Asked& asked) {
    Line& line = asked.line;
    check(asked, line.kind + ", leaving it", line.respawn, promise_of_respawn(line.precision, line.kind));
    if (promises_closed_seams(line.precision) && line.seams.wrong() > 0)
      asked.tier.broken.push_back(
          fmt::format("{}, closed surfaces: {} leaks and {} double hits of {} rays, the first: {}", line.kind,
                      line.seams.leaks, line.seams.doubles, line.seams.rays, line.seams.first_wrong));
    line.nanoseconds_per_test = asked.probe.nanoseconds_per_test();
    result_.lines.push_back(std::move(line));
  }

  void conclude(TierResult& tier) {
    const bool is_refused = tier.canary.tier.verdict == Verdict::refused;
    const bool is_claimed = tier.tier.precision == Precision::fp64 && device_.info().fp64;
    tier.is_failed = is_refused ? is_claimed : !tier.broken.empty();
    if (tier.broken.empty()) return;
    tier.tier.verdict = Verdict::refused;
    tier.tier.why = fmt::format("{} promise{} broken", tier.broken.size(), tier.broken.size() == 1 ? " is" : "s are");
  }

  const Device& device_;
  const Step& step_;
  Fault fault_;
  SelftestResult result_;
  /// By kind; row i is that of question i.
  std::map<std::string, std::pair<std::vector<const Row*>, std::vector<Question>>> catalogue_of_;
  std::size_t done_ = 0, total_ = 1;
};

}  // namespace

bool SelftestResult::passed() const {
  return std::none_of(tiers.begin(), tiers.end(), [](const TierResult& tier) { return tier.is_failed; });
}

SelftestResult run_selftest(const Device& device, const SelftestOptions& options, const Step& step) {
  return Selftest(device, options, step).run();
}

}  // namespace strahl::selftest
