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
