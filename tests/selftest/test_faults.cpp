// SPDX-License-Identifier: MIT
// The self test, run as a user runs it, on sound devices and on wrong ones: whatever fault is injected, a precision is
// refused or the exit code is 7. 10 s on PoCL, 15 s on rusticl, where no program is cached.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "cli/program.h"
#include "selftest/faults.h"

using namespace strahl_test;
using Json = nlohmann::json;

namespace {

struct Run {
  int code;
  Json json;

  [[nodiscard]] Json tier(const std::string& precision) const {
    for (const Json& tier : json.at("tiers"))
      if (tier.at("precision") == precision) return tier;
    throw std::logic_error("no tier " + precision);
  }
};

Run selftest(std::vector<std::string> arguments) {
  const Folder folder;
  arguments.insert(arguments.begin(), "selftest");
  arguments.insert(arguments.end(), {"--json", "-", "--no-progress"});
  const Outcome outcome = folder.run(arguments, {{"RUSTICL_ENABLE", "llvmpipe"}});
  INFO(outcome.err);
  REQUIRE((outcome.code == 0 || outcome.code == 7));
  CHECK(outcome.err.empty());
  return {outcome.code, Json::parse(outcome.out)};
}

/// What the self test should make of a fault in the robust tier.
struct Expectation {
  const char* fault;
  const char* kind;  ///< One where it shows.
  const char* verdict;
  int code;
  const char* said;  ///< Part of the reason, or of a promise that is broken.
};

constexpr Expectation expectations[] = {
    {"contraction", "sphere", "refused", 0, "contracted"},
    {"relaxed-maths", "sphere", "refused", 0, "reordered"},
    {"ftz", "sphere", "refused", 0, "below the normal range"},
    {"fastdiv", "sphere", "refused", 0, "quotients"},
    {"fastsqrt", "sphere", "refused", 0, "square roots"},
    {"nofma", "sphere", "refused", 0, "fma"},
    // A fault that Mesa's fma has, and that does not matter at ordinary scale.
    {"nofma-denormals", "plane", "degraded", 0, "holds for products above 2^-79, lengths above 2^-39"},
    {"nan-compare", "sphere", "refused", 0, "NaN"},
    {"strict-edges", "triangle", "refused", 7, "closed surfaces"},
    {"wrong-primitive", "triangle", "refused", 7, "closed surfaces"},
    {"forget-left", "sphere", "refused", 7, "leaving it"},
};

/// The answer has so many lines, and so many of them in robust.
void hold_sound(const std::vector<std::string>& asks, std::size_t lines, int robust_lines) {
  const Run run = selftest(asks);
  CHECK(run.code == 0);
  CHECK(run.json.at("passed") == true);
  CHECK(run.json.at("lines").size() == lines);
  for (const Json& tier : run.json.at("tiers")) {
    CHECK(tier.at("verdict") == "holds");
    CHECK(tier.at("canary").at("findings").size() == 15);
  }
  int compared = 0;
  for (const Json& line : run.json.at("lines")) {
    INFO(line.dump());
    CHECK(line.at("laws").at("cases") >= 16000);
    CHECK(line.at("catalogue").at("cases") > 500);
    CHECK(line.at("respawn").at("cases") > 2000);
    CHECK(line.at("ns_per_test") > 0);
    const std::string kind = line.at("primitive");
    CHECK((line.at("seams").at("rays") > 0) == (kind == "triangle" || kind == "parallelogram"));
    if (line.at("precision") != "robust") continue;
    ++compared;
    CHECK(line.at("laws").at("wrong") == 0);
    // Of a t that is correctly rounded to float; the exact one is rounded to double.
    CHECK(line.at("laws").at("max_ulp") <= 0.5);
    CHECK(line.at("laws").at("max_ulp") > 0);
    CHECK(line.at("laws").at("p99_ulp") <= line.at("laws").at("max_ulp"));
  }
  CHECK(compared == robust_lines);
}

}  // namespace

TEST_CASE("a sound device passes, for every primitive") { hold_sound({"-d", "pocl", "--tier", "robust"}, 7, 7); }

TEST_CASE("a sound device passes, in every precision and for every primitive", "[slow]") {
  hold_sound({"-d", "pocl"}, 4 * 7, 7);
}

TEST_CASE("rusticl's robust tier is degraded by loops that end early alone, and its missing double is no failure") {
  const Run run =
      selftest({"-d", "llvmpipe", "--tier", "robust", "--tier", "double", "--kind", "sphere", "--kind", "triangle"});
  CHECK(run.code == 0);
  CHECK(run.tier("robust").at("verdict") == "degraded");
  const std::string why = run.tier("robust").at("why");
  CHECK(why.starts_with("ends loops after "));
  CHECK_FALSE(contains(why, ";"));
  CHECK(run.tier("robust").at("broken").empty());
  CHECK(run.tier("double").at("verdict") == "refused");
  CHECK(run.tier("double").at("failed") == false);
  CHECK(run.json.at("lines").size() == 2);
}

TEST_CASE("no fault goes unnoticed") {
  std::vector<std::string> tried;
  for (const Expectation& expected : expectations) {
    INFO(expected.fault);
    tried.emplace_back(expected.fault);
    const Run run = selftest({"-d", "pocl", "--tier", "robust", "--kind", expected.kind, "--inject", expected.fault});
    CHECK(run.code == expected.code);
    const Json tier = run.tier("robust");
    CHECK(tier.at("verdict") == expected.verdict);
    CHECK(contains(tier.dump(), expected.said));
  }
  std::vector<std::string> known;
  for (const auto& fault : strahl::selftest::fault_names()) known.push_back(fault.name);
  CHECK(tried == known);
}

TEST_CASE("a precision that the device claims and does not keep is a failure") {
  const Run run = selftest({"-d", "pocl", "--tier", "double", "--kind", "plane", "--inject", "contraction"});
  CHECK(run.code == 7);
  CHECK(run.tier("double").at("failed") == true);
}

TEST_CASE("a fault that finds nothing to change is no fault") {
  strahl::selftest::Fault fault("strict-edges");
  strahl::ProgramSource source{"FN int f(void) { return 1; }", ""};
  fault.inject(source);
  CHECK_THROWS_AS(fault.require_injected(), std::logic_error);
  source.text = "FN maskw signs_differ(void) { return negative & positive; }";
  fault.inject(source);
  CHECK_NOTHROW(fault.require_injected());
  CHECK(contains(source.text, "eq_w(a, zero)"));
}

TEST_CASE("a precision or kind that is named twice is asked once") {
  const Run run =
      selftest({"-d", "pocl", "--tier", "robust", "--tier", "robust", "--kind", "plane", "--kind", "plane"});
  CHECK(run.code == 0);
  CHECK(run.json.at("tiers").size() == 1);
  CHECK(run.json.at("lines").size() == 1);
}

TEST_CASE("a kind of primitive that there is not is wrong usage") {
  const Folder folder;
  const Outcome outcome = folder.run({"selftest", "-d", "pocl", "--kind", "trangle"});
  CHECK(outcome.code == 2);
  CHECK(contains(outcome.err, "did you mean \"triangle\""));
}

TEST_CASE("the table says what the JSON says") {
  const Folder folder;
  const Outcome outcome = folder.run(
      {"selftest", "-d", "pocl", "--tier", "robust", "--kind", "triangle", "--json", folder.path("report.json")});
  CHECK(outcome.code == 0);
  const Json json = Json::parse(read_text(folder.path("report.json")));
  CHECK(contains(outcome.out, json.at("device").get<std::string>()));
  CHECK(contains(outcome.out, "robust  triangle"));
  CHECK(contains(outcome.out, "0/12000"));
  CHECK(contains(outcome.out, "robust  holds"));
}
