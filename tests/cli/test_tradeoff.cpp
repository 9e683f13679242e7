// SPDX-License-Identifier: MIT
// `strahl tradeoff` on a device: files, table, JSON, what it refuses, and Ctrl-C. 3 s.
#include <catch2/catch.hpp>
#include <chrono>
#include <csignal>
#include <nlohmann/json.hpp>
#include <thread>

#include "cli/program.h"

using namespace strahl_test;

namespace {

std::vector<std::string> command(const std::vector<std::string>& more = {}) {
  std::vector<std::string> words{"tradeoff", "scene.xml", "-o", "study",   "--precision", "robust,fast", "--spp",
                                 "16,1,4",   "--seeds",   "2",  "--width", "24",          "--sampler",   "independent"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

}  // namespace

TEST_CASE("a report, a table, JSON; the second run takes everything over") {
  const Folder folder;
  folder.file("scene.xml", glowing_sphere);
  const Outcome first = folder.run(command());
  INFO(first.err);
  REQUIRE(first.code == 0);
  CHECK(folder.files() == std::vector<std::string>{"scene.xml", "study"});
  for (const char* name : {"report.html", "tradeoff.json", "tradeoff.csv", "reference.exr", "reference.png"})
    CHECK(std::filesystem::exists(folder.path("study/") + name));
  CHECK(contains(first.out, "Pareto front"));
  CHECK(contains(first.out, "slope"));
  CHECK(contains(first.out, "generic"));
  CHECK(contains(first.out, "against double, 256 samples a pixel"));
  CHECK(contains(first.err, "9 points"));
  CHECK(contains(first.err, "24×18"));

  const Outcome second = folder.run(command({"--json", "-q"}));
  INFO(second.err);
  REQUIRE(second.code == 0);
  CHECK(second.err.empty());
  CHECK(second.out == read_text(folder.path("study/tradeoff.json")));
  const auto json = nlohmann::json::parse(second.out);
  CHECK(json["points"].size() == 9);
  CHECK(json["points"][0]["id"] == "robust-independent-1spp-specialised");
  CHECK(json["points"][0]["max_depth"].is_null());
  CHECK(json["scene"] == "scene.xml");
  CHECK(contains(json["command"], "strahl tradeoff scene.xml"));
  CHECK(contains(folder.run(command({"--no-generic"})).err, "6 points, 6 of them taken over"));

  const Outcome other = folder.run(command({"--reference-spp", "64"}));
  CHECK(other.code == 2);
  CHECK(contains(other.err, "reference"));
  CHECK(contains(other.err, "--restart"));
}

TEST_CASE("what is refused") {
  const Folder folder;
  folder.file("scene.xml", glowing_sphere);
  const auto code = [&](const std::vector<std::string>& more, const std::string& word) {
    std::vector<std::string> words{"tradeoff", "scene.xml"};
    words.insert(words.end(), more.begin(), more.end());
    const Outcome outcome = folder.run(words);
    INFO(outcome.err);
    CHECK(contains(outcome.err, word));
    CHECK(outcome.out.empty());
    return outcome.code;
  };
  CHECK(code({"--precision", "quadruple"}, "unknown precision") == 2);
  CHECK(code({"--sampler", "halton"}, "unknown sampler") == 2);
  CHECK(code({"--spp", "0"}, "--spp") == 2);
  CHECK(code({"--seeds", "1"}, "--seeds") == 2);
  CHECK(code({"--depth", "2"}, "emission has no max_depth") == 2);
  CHECK(code({"--depth=-2"}, "--depth -2") == 2);
  CHECK(code({"--reference", "nowhere.exr"}, "nowhere.exr") == 3);
  CHECK(code({"-d", "nothing-of-that-name"}, "nothing-of-that-name") == 4);
  folder.file("in-the-way", "");
  CHECK(code({"-o", "in-the-way/study"}, "in-the-way") != 0);
  CHECK_FALSE(std::filesystem::exists(folder.path("scene.tradeoff/tradeoff.json")));
}

TEST_CASE("what no point can be measured with is told before the folder is made") {
  const Folder folder;
  folder.file("scene.xml", glowing_sphere);
  std::string lit = glowing_sphere;
  lit.replace(lit.find("\"emission\""), 10, "\"ptracer\"");
  folder.file("lit.xml", lit);
  const std::string one(4, '\0'), nan("\0\0\xc0\x7f", 4);  // Floats, the low byte first.
  const auto pixels = [](const std::string& value, int count) {
    std::string all;
    for (int i = 0; i < count; ++i) all += value;
    return all;
  };
  folder.file("small.pfm", "PF\n2 2\n-1.0\n" + pixels(one, 12));
  folder.file("grey.pfm", "Pf\n2 2\n-1.0\n" + pixels(one, 4));
  folder.file("nan.pfm", "PF\n2 2\n-1.0\n" + pixels(one, 11) + nan);
  const auto refusal = [&](std::vector<std::string> words, int code) {
    words.insert(words.begin(), "tradeoff");
    const Outcome outcome = folder.run(words);
    INFO(outcome.err);
    CHECK(outcome.code == code);
    return outcome.err;
  };
  CHECK(contains(refusal({"scene.xml", "--width", "24", "--reference", "small.pfm"}, 3),
                 "\"small.pfm\" (--reference) has 2 x 2 pixels and the study's pictures 24 x 18: leave --width out"));
  CHECK(contains(refusal({"scene.xml", "--reference", "grey.pfm"}, 3), "\"grey.pfm\" (--reference): colour channels"));
  CHECK(
      contains(refusal({"scene.xml", "--reference", "nan.pfm"}, 3), "\"nan.pfm\" (--reference): the reference holds"));
  CHECK(contains(refusal({"lit.xml", "--sampler", "sobol,centre"}, 2), "centres alone"));
  CHECK(contains(refusal({"lit.xml", "--width", "128", "--spp", "1,2000000"}, 2), "--spp 2000000: the film holds"));
  CHECK(contains(refusal({"lit.xml", "--width", "128", "--reference-spp", "2000000"}, 2), "--reference-spp 2000000: "));
  CHECK(folder.files() == std::vector<std::string>{"grey.pfm", "lit.xml", "nan.pfm", "scene.xml", "small.pfm"});
}

TEST_CASE("double is asked for by name: a device without it is refused, whatever else is trusted") {
  const Folder folder;
  folder.file("scene.xml", glowing_sphere);
  const Outcome outcome =
      folder.run({"tradeoff", "scene.xml", "-d", "llvmpipe", "--precision", "double", "--no-canary"},
                 {{"RUSTICL_ENABLE", "llvmpipe"}});
  INFO(outcome.err);
  CHECK(outcome.code == 4);
  CHECK_FALSE(contains(outcome.err, "canary"));
  CHECK_FALSE(contains(outcome.err, "cannot keep"));
}

TEST_CASE("Ctrl-C: what was measured stays measured") {
  const Folder folder;
  folder.file("scene.xml", glowing_sphere);
  // Hours, in its second point.
  const auto with = [](const std::string& spp) {
    return std::vector<std::string>{"tradeoff",     "scene.xml",       "-o", "study",     "--precision",
                                    "robust",       "--spp",           spp,  "--width",   "24",
                                    "--no-generic", "--reference-spp", "64", "--sampler", "independent"};
  };
  const Outcome stopped = folder.run(with("1,2000000"), {}, [&](pid_t child) {
    using namespace std::chrono_literals;
    const std::string first = folder.path("study/points/robust-independent-1spp-specialised.json");
    for (int wait = 0; wait < 600 && !std::filesystem::exists(first); ++wait) std::this_thread::sleep_for(100ms);
    std::this_thread::sleep_for(500ms);
    kill(child, SIGINT);
  });
  INFO(stopped.err);
  CHECK(stopped.code == 130);
  CHECK(contains(stopped.err, "1 of 2 points"));
  CHECK_FALSE(std::filesystem::exists(folder.path("study/tradeoff.json")));
  const Outcome resumed = folder.run(with("1,4"));
  INFO(resumed.err);
  CHECK(resumed.code == 0);
  CHECK(contains(resumed.err, "2 points, 1 of them taken over"));
}
