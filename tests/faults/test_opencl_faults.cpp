// SPDX-License-Identifier: MIT
// Every OpenCL call of a render fails in turn: no crash, no hang (the test's time limit), no success whose picture is
// another one, and nothing older than the last checkpoint is lost (docs/reliability.md).
#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "checkpoint/checkpoint.h"
#include "cli/program.h"
#include "faults/launches.h"
#include "image/image_io.h"

using namespace strahl_test;
namespace fs = std::filesystem;

namespace {

constexpr int out_of_resources = -5;

/// A scene in small, gone on with from a checkpoint.
class FaultyRender {
 public:
  explicit FaultyRender(const std::string& scene) : scene_(STRAHL_SOURCE_DIR "/scenes/" + scene) {
    const Outcome before = folder_.run({scene_, "--width", "24", "--spp", "8", "-d", "pocl", "-q", "--sampler", "sobol",
                                        "--checkpoint", "kept", "-o", "before.pfm"});
    INFO(before.err);
    REQUIRE(before.code == 0);
    kept_ = read_text(folder_.path("kept"));
    REQUIRE(run({}).code == 0);
    picture_ = strahl::read_image(folder_.path("out.pfm"));
    std::istringstream log(read_text(folder_.path("calls.log")));
    for (std::string line; std::getline(log, line);) calls_.push_back(line);
    REQUIRE(calls_.size() > 100);
  }

  [[nodiscard]] const std::vector<std::string>& calls() const { return calls_; }

  /// call: counts from 1. Threads make calls beside each other, so it is found again among those of its name.
  void fail(std::size_t call, int code) {
    const std::string& name = calls_[call - 1];
    const auto number = std::count(calls_.begin(), calls_.begin() + static_cast<std::ptrdiff_t>(call), name);
    INFO(scene_ << ", call " << call << " of " << calls_.size() << " (" << name << ") returns " << code);
    const Outcome outcome = run({{"STRAHL_CL_FAULT_NAME", name},
                                 {"STRAHL_CL_FAULT_CALL", std::to_string(number)},
                                 {"STRAHL_CL_FAULT_CODE", std::to_string(code)}});
    INFO(outcome.err);
    REQUIRE(outcome.signal == 0);
    if (outcome.code == 0) {
      ++successes;
      CHECK(strahl::read_image(folder_.path("out.pfm")).data == picture_.data);
    } else {
      ++failures;
      CHECK((outcome.code == 1 || outcome.code == 4 || outcome.code == 5));
      CHECK(contains(outcome.err, "strahl: error: "));
      if (fs::exists(folder_.path("out.pfm"))) CHECK(strahl::read_image(folder_.path("out.pfm")).data == picture_.data);
    }
    CHECK(strahl::read_checkpoint(folder_.path("c.ckpt")).header.least >= 8);
  }

  /// The second launch of samples never ends.
  void hang() {
    const Outcome outcome = run(hanging_launch(2), {"--watchdog", "1s"});
    INFO(outcome.err);
    CHECK(outcome.code == 1);
    CHECK(contains(outcome.err, "has not come back from a launch for 1 s"));
    CHECK(contains(outcome.err, "\"c.ckpt\" has the last checkpoint"));
    CHECK_FALSE(fs::exists(folder_.path("out.pfm")));
    CHECK(strahl::read_checkpoint(folder_.path("c.ckpt")).header.least >= 8);
  }

  /// The first launch of a run that has written no checkpoint, whatever an earlier one has left under that name.
  void hang_before_a_checkpoint() {
    const std::vector<std::string> options{scene_, "--width", "24",    "--spp",        "9",        "-d",         "pocl",
                                           "-q",   "-o",      "n.pfm", "--checkpoint", "new.ckpt", "--watchdog", "1s"};
    std::map<std::string, std::string> environment = hanging_launch(1);
    environment["OPENCL_LAYERS"] = STRAHL_FAIL_OPENCL;
    const Outcome outcome = folder_.run(options, environment);
    INFO(outcome.err);
    CHECK(outcome.code == 1);
    CHECK(contains(outcome.err, "nothing was kept: no checkpoint was written yet"));
    CHECK_FALSE(contains(outcome.err, "has the last checkpoint"));
  }

  /// One of --frames, which keep no checkpoint; some launch in their midst.
  void hang_in_frames() {
    const Outcome outcome = folder_.run({scene_, "--width", "24", "--frames", "1000", "--time", "20ms", "-d", "pocl",
                                         "-q", "-o", "f.pfm", "--watchdog", "1s"},
                                        {{"OPENCL_LAYERS", STRAHL_FAIL_OPENCL},
                                         {"STRAHL_CL_FAULT_NAME", launch_call},
                                         {"STRAHL_CL_FAULT_CALL", "100"},
                                         {"STRAHL_CL_FAULT_CODE", "hang"}});
    INFO(outcome.err);
    CHECK(outcome.code == 1);
    CHECK(contains(outcome.err, "has not come back from a launch for 1 s"));
  }

  /// What is known of the frames before is told.
  void fail_in_frames() {
    const Outcome outcome = folder_.run({scene_, "--width", "24", "--frames", "1000", "--time", "1s", "--spp", "4",
                                         "-d", "pocl", "-q", "-o", "g.pfm", "--stats", "g.json"},
                                        {{"OPENCL_LAYERS", STRAHL_FAIL_OPENCL},
                                         {"STRAHL_CL_FAULT_NAME", launch_call},
                                         {"STRAHL_CL_FAULT_CALL", "100"},
                                         {"STRAHL_CL_FAULT_CODE", std::to_string(out_of_resources)}});
    INFO(outcome.err);
    CHECK(outcome.code == 1);
    CHECK(contains(outcome.err, "CL_OUT_OF_RESOURCES"));
    REQUIRE(fs::exists(folder_.path("g.json")));
    const auto stats = nlohmann::json::parse(read_text(folder_.path("g.json")));
    const auto count = static_cast<std::ptrdiff_t>(stats.at("frames").size());
    CHECK(count > 0);
    const std::vector<std::string> files = folder_.files();
    CHECK(count == std::count_if(files.begin(), files.end(), [](const std::string& name) {
            return name.rfind("g.", 0) == 0 && contains(name, ".pfm");
          }));
  }

  /// Clearing the film takes longer than a launch may.
  void clear_slowly() {
    REQUIRE(std::count(calls_.begin(), calls_.end(), "clEnqueueFillBuffer") > 0);
    const Outcome outcome = run({{"STRAHL_CL_FAULT_NAME", "clEnqueueFillBuffer"},
                                 {"STRAHL_CL_FAULT_CALL", "1"},
                                 {"STRAHL_CL_FAULT_CODE", "slow"},
                                 {"STRAHL_CL_FAULT_TIMES", "1"},
                                 {"STRAHL_CL_FAULT_SECONDS", "2"}},
                                {"--watchdog", "1s"});
    INFO(outcome.err);
    CHECK(outcome.code == 0);
    CHECK(strahl::read_image(folder_.path("out.pfm")).data == picture_.data);
  }

  int successes = 0, failures = 0;

 private:
  /// Of samples, counted from 1.
  [[nodiscard]] static std::map<std::string, std::string> hanging_launch(int number) {
    return {{"STRAHL_CL_FAULT_NAME", launch_call},
            {"STRAHL_CL_FAULT_CALL", std::to_string(warm_up_launches + number)},
            {"STRAHL_CL_FAULT_CODE", "hang"}};
  }

  [[nodiscard]] Outcome run(std::map<std::string, std::string> environment, const std::vector<std::string>& more = {}) {
    for (const char* name : {"out.pfm", "calls.log"}) fs::remove(folder_.path(name));
    folder_.file("c.ckpt", kept_);
    environment["OPENCL_LAYERS"] = STRAHL_FAIL_OPENCL;
    environment["STRAHL_CL_FAULT_LOG"] = folder_.path("calls.log");
    std::vector<std::string> options{scene_, "--width",   "24",    "--spp",    "9",      "-d", "pocl",
                                     "-q",   "--sampler", "sobol", "--resume", "c.ckpt", "-o", "out.pfm"};
    options.insert(options.end(), more.begin(), more.end());
    return folder_.run(options, environment);
  }

  Folder folder_;
  std::string scene_, kept_;
  strahl::Image picture_;
  std::vector<std::string> calls_;
};

}  // namespace

TEST_CASE("each OpenCL call fails in turn") {
  FaultyRender faulty("cornell/cornell-box.xml");
  // The first and the last call of each function.
  std::map<std::string, std::pair<std::size_t, std::size_t>> places;
  for (std::size_t call = 1; call <= faulty.calls().size(); ++call) {
    auto [place, is_new] = places.try_emplace(faulty.calls()[call - 1], call, call);
    if (!is_new) place->second.second = call;
  }
  REQUIRE(places.size() > 20);
  for (const auto& [name, place] : places) {
    faulty.fail(place.first, out_of_resources);
    if (place.second != place.first) faulty.fail(place.second, out_of_resources);
  }
  CHECK(faulty.failures > faulty.successes);
}

TEST_CASE("a kernel that never ends is left behind") {
  FaultyRender render("lecture/lit.xml");
  render.hang();
  render.hang_before_a_checkpoint();
  render.hang_in_frames();
}

TEST_CASE("a frame that fails loses nothing of those before it") { FaultyRender("lecture/lit.xml").fail_in_frames(); }

TEST_CASE("a watchdog does not count what comes before the first launch") {
  FaultyRender("lecture/lit.xml").clear_slowly();
}

TEST_CASE("each OpenCL call fails in turn, all of them, and each function with each code") {
  if (std::getenv("STRAHL_ALL_FAULTS") == nullptr) return;
  for (const char* scene : {"cornell/cornell-box.xml", "lecture/lit.xml", "mesh/torus-and-icosphere.xml"}) {
    FaultyRender faulty(scene);
    for (std::size_t call = 1; call <= faulty.calls().size(); ++call) faulty.fail(call, out_of_resources);
    if (std::string(scene) != "cornell/cornell-box.xml") {
      WARN(scene << ": " << faulty.failures << " failed, " << faulty.successes << " came out all the same");
      continue;
    }
    std::map<std::string, std::size_t> first;
    for (std::size_t call = 1; call <= faulty.calls().size(); ++call) first.try_emplace(faulty.calls()[call - 1], call);
    for (const auto& [name, call] : first)
      for (int code = -1; code >= -72; --code)
        if (code > -20 || code <= -30) faulty.fail(call, code);
    WARN(scene << ": " << faulty.failures << " failed, " << faulty.successes << " came out all the same");
  }
}
